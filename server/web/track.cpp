// SPDX-License-Identifier: MIT
#include "server/web/track.hpp"

#include <cmath>
#include <numbers>

namespace mirocup::web {

namespace {

std::int32_t rounded(double value, double unit) {
  return static_cast<std::int32_t>(std::lround(value / unit));
}

// The heading nearest to the one before among those that differ by whole turns.
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
  Frame frame;
  const auto add_point = [&frame](const Vec2& point) {
    frame.push_back(rounded(point.x(), length_unit));
    frame.push_back(rounded(point.y(), length_unit));
  };
  frame.push_back(rounded(scene.clock, clock_unit));
  add_point(scene.ball.position);
  for (const Team team : both_teams) {
    for (int i = 0; i < robots; ++i) {
      const simulator::BodyState& robot = scene.robots[index_of(team)][i];
      add_point(robot.position);
      const std::int32_t last = before.empty() ? 0 : before[frame.size()];
      frame.push_back(heading_near(robot.heading.angle(), last));
    }
  }
  return frame;
}

void Track::add(const match::Snapshot& scene) {
  const Frame frame = frame_of(scene, robots_, last_);
  if (frames_ == 0) {
    last_.assign(frame.size(), 0);
    last_change_.assign(frame.size(), 0);
    columns_.resize(frame.size());
  }
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const std::int32_t change = frame[i] - last_[i];
    put(columns_[i], change - last_change_[i]);
    last_change_[i] = change;
  }
  last_ = frame;
  ++frames_;
}

std::string Track::packed() const {
  std::string bytes;
  for (const std::string& column : columns_) bytes += column;
  return base64(bytes);
}

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = i; j < i + 3; ++j) {
      group = group << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const bool is_padding = i + j > bytes.size();
      text += is_padding ? '=' : digits[group >> (18 - 6 * j) & 63];
    }
  }
  return text;
}

}  // namespace mirocup::web
