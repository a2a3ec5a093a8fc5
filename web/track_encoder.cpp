// SPDX-License-Identifier: MIT
#include "web/track_encoder.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace mirocup::web {

namespace {

// page/track.js reads these units and this order; "blue robots first" is the order of both_teams.
static_assert(length_unit == 0.0005 && clock_unit == 0.001 && heading_units_a_turn == 2048);
static_assert(both_teams[0] == Team::blue);

// Clock, ball x and y; x, y and heading of each robot of both teams.
constexpr std::size_t frame_size(int robots) {
  return 3 + 2 * 3 * static_cast<std::size_t>(robots);
}

std::int32_t rounded(double value, double unit) {
  return static_cast<std::int32_t>(std::lround(value / unit));
}

// The heading of that angle, in units, that is nearest to the one before; whole turns are added.
std::int32_t heading_near(double angle, std::int32_t before) {
  const double unit = 2.0 * std::numbers::pi / heading_units_a_turn;
  const std::int32_t now = rounded(angle, unit);
  const std::int32_t turns = rounded(before - now, heading_units_a_turn);
  return now + turns * heading_units_a_turn;
}

void put(std::string& column, std::int32_t value) {
  auto bits = (static_cast<std::uint32_t>(value) << 1) ^ static_cast<std::uint32_t>(value >> 31);
  for (; bits >= 0x80; bits >>= 7) column += static_cast<char>(bits | 0x80);
  column += static_cast<char>(bits);
}

}  // namespace

Frame frame_of(const match::Snapshot& scene, int robots, const Frame& before) {
  assert(robots >= 0 && robots <= max_robots_per_team);
  assert(before.empty() || before.size() == frame_size(robots));
  Frame frame;
  const auto add_point = [&frame](const Vec2& point) {
    frame.push_back(rounded(point.x(), length_unit));
    frame.push_back(rounded(point.y(), length_unit));
  };
  frame.push_back(rounded(scene.clock, clock_unit));
  add_point(scene.ball.position);
  for (const Team team : both_teams) {
    for (int i = 0; i < robots; ++i) {
      const match::ObservedRobot& robot = scene.robots[index_of(team)][i];
      add_point(robot.position);
      const std::int32_t last = before.empty() ? 0 : before[frame.size()];
      frame.push_back(heading_near(robot.heading, last));
    }
  }
  return frame;
}

void ColumnEncoder::add(const Frame& row) {
  if (rows_ == 0) {
    last_.assign(row.size(), 0);
    last_change_.assign(row.size(), 0);
    columns_.resize(row.size());
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::int32_t change = row[i] - last_[i];
    put(columns_[i], change - last_change_[i]);
    last_change_[i] = change;
  }
  last_ = row;
  ++rows_;
}

std::string ColumnEncoder::bytes() const {
  std::string bytes;
  for (const std::string& column : columns_) bytes += column;
  return bytes;
}

}  // namespace mirocup::web
