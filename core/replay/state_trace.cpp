// SPDX-License-Identifier: MIT
#include "core/replay/state_trace.hpp"

#include <charconv>

namespace mirocup::replay {

namespace {

std::uint8_t fingerprint(const simulator::BodyState& robot) {
  StateHash hash;
  for (const double part :
       {robot.position.x(), robot.position.y(), robot.heading.cos, robot.heading.sin,
        robot.twist.forward, robot.twist.left, robot.twist.omega}) {
    hash.add(part);
  }
  return static_cast<std::uint8_t>(hash.value() >> 56);
}

std::uint8_t fingerprint(const simulator::BallState& ball) {
  StateHash hash;
  for (const double part :
       {ball.position.x(), ball.position.y(), ball.velocity.x(), ball.velocity.y()}) {
    hash.add(part);
  }
  return static_cast<std::uint8_t>(hash.value() >> 56);
}

// All digits: two values that differ read differently.
std::string exact(double value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string exact(const Vec2& v) {
  return "(" + exact(v.x()) + ", " + exact(v.y()) + ")";
}

}  // namespace

void StateTrace::add(const match::Leg& leg) {
  if (leg.log().size() <= ticks.size()) return;  // a fault ended it before anything moved
  if (ticks.capacity() == 0) ticks.reserve(leg.log().capacity());
  const int robots = leg.field().robots_per_team;
  Checkpoint* checkpoint = nullptr;
  if (ticks.size() % checkpoint_ticks == 0) checkpoint = &checkpoints.emplace_back();
  Fingerprints& fingerprints = ticks.emplace_back();
  for (const Team team : both_teams) {
    for (int i = 0; i < robots; ++i) {
      const int body = index_of(team) * robots + i;
      const simulator::BodyState robot = leg.robot(team, i);
      fingerprints[body] = fingerprint(robot);
      if (checkpoint != nullptr) checkpoint->robots[body] = robot;
    }
  }
  fingerprints[2 * robots] = fingerprint(leg.ball());
  if (checkpoint != nullptr) checkpoint->ball = leg.ball();
}

std::vector<int> differing_bodies(const StateTrace& a, const StateTrace& b, std::size_t tick,
                                  int bodies) {
  std::vector<int> differing;
  if (tick >= a.ticks.size() || tick >= b.ticks.size()) return differing;
  for (int body = 0; body < bodies; ++body) {
    if (a.ticks[tick][body] != b.ticks[tick][body]) differing.push_back(body);
  }
  return differing;
}

std::string body_name(int body, int robots_per_team) {
  if (body == 2 * robots_per_team) return "the ball";
  const Team team = body < robots_per_team ? Team::blue : Team::yellow;
  return std::string(to_string(team)) + " robot " + std::to_string(body % robots_per_team);
}

std::string body_text(const Checkpoint& checkpoint, int body, int robots_per_team) {
  if (body == 2 * robots_per_team) {
    return "at " + exact(checkpoint.ball.position) + " m with " + exact(checkpoint.ball.velocity) +
           " m/s";
  }
  const simulator::BodyState& robot = checkpoint.robots[body];
  return "at " + exact(robot.position) + " m, heading " + exact(robot.heading.forward()) +
         ", with " + exact(robot.twist.forward) + " m/s forward, " + exact(robot.twist.left) +
         " m/s to the left, " + exact(robot.twist.omega) + " rad/s";
}

}  // namespace mirocup::replay
