// SPDX-License-Identifier: MIT
#include "web/heat_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::web {

namespace {

constexpr double cell = 0.1;  // m, about

int cells_of(double length) {
  return static_cast<int>(std::lround(length / cell));
}

}  // namespace

HeatMap::HeatMap(const field::Field& field)
    : field_(field),
      columns_(cells_of(2.0 * field.half_length)),
      rows_(cells_of(2.0 * field.half_width)),
      cells_(static_cast<std::size_t>(columns_ * rows_)) {}

void HeatMap::add(const match::Snapshot& scene) {
  const bool is_play = scene.state == match::State::PLAY;
  if (!std::exchange(was_play_, is_play) || !is_play) return;
  const Vec2 ball =
      attack_sign(scene.left == Team::blue ? End::left : End::right) * scene.ball.position;
  const auto cell_of = [](double at, double half, int count) {
    return std::clamp(static_cast<int>((at + half) / (2.0 * half) * count), 0, count - 1);
  };
  const int column = cell_of(ball.x(), field_.half_length, columns_);
  const int row = cell_of(-ball.y(), field_.half_width, rows_);
  ++cells_[static_cast<std::size_t>(row * columns_ + column)];
}

}  // namespace mirocup::web
