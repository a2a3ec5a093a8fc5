// SPDX-License-Identifier: MIT
#include "core/match/placement_request.hpp"

#include "core/match/observation.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace mirocup::match {

namespace {

// Far more than anybody who adds up angles gets to, and few enough turns to be reduced exactly.
constexpr double largest_heading = 1e6;  // rad

Pose to_pose(const AskedPose& pose, End end) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const bool is_angle = std::abs(pose.heading) <= largest_heading;
  const Heading heading = is_angle ? Heading::from_angle(pose.heading) : Heading{nowhere, nowhere};
  return team_frame(end, Pose{{pose.x, pose.y}, heading});
}

}  // namespace

Poses standing(const Observation& observation) {
  Poses poses{.ball_x = observation.ball.x(), .ball_y = observation.ball.y(), .robots = {}};
  for (int i = 0; i < observation.robots; ++i) {
    const ObservedRobot& robot = observation.own[i];
    poses.robots[i] = {robot.position.x(), robot.position.y(), robot.heading};
  }
  return poses;
}

bool is_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool is_same(const AskedPose& a, const AskedPose& b) {
  return is_same(a.x, b.x) && is_same(a.y, b.y) && is_same(a.heading, b.heading);
}

bool is_same(const Poses& a, const Poses& b, int robots) {
  for (int i = 0; i < robots; ++i) {
    if (!is_same(a.robots[i], b.robots[i])) return false;
  }
  return is_same(a.ball_x, b.ball_x) && is_same(a.ball_y, b.ball_y);
}

referee::Placement asked_placement(const Scene& scene, Team team, const Poses& shown,
                                   const Poses& asked, int robots) {
  const End end = scene.left == team ? End::left : End::right;
  referee::Placement placement;
  placement.ball = scene.ball.position;
  if (!is_same(asked.ball_x, shown.ball_x) || !is_same(asked.ball_y, shown.ball_y)) {
    placement.ball = team_frame(end, Vec2{asked.ball_x, asked.ball_y});
  }
  for (const Team other : both_teams) {
    const End at = scene.left == other ? End::left : End::right;
    for (int i = 0; i < robots; ++i) {
      const simulator::BodyState& robot = scene.robots[index_of(other)][i];
      placement.robots[index_of(at)][i] = {robot.position, robot.heading};
    }
  }
  for (int i = 0; i < robots; ++i) {
    if (is_same(asked.robots[i], shown.robots[i])) continue;
    placement.robots[index_of(end)][i] = to_pose(asked.robots[i], end);
  }
  return placement;
}

}  // namespace mirocup::match
