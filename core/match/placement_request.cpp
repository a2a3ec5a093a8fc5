// SPDX-License-Identifier: MIT
#include "core/match/placement_request.hpp"

#include "core/match/observation.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace mirocup::match {

namespace {

// Larger than any angle that a team accumulates in a leg, and small enough to be reduced exactly.
constexpr double max_heading = 1e6;  // rad

Pose to_pose(const RequestedPose& pose, End end) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const bool is_angle = std::abs(pose.heading) <= max_heading;
  const Heading heading = is_angle ? Heading::from_angle(pose.heading) : Heading{nowhere, nowhere};
  return team_frame(end, Pose{{pose.x, pose.y}, heading});
}

double to_steps(double value) {
  return std::nearbyint(value / placement_step) * placement_step;
}

bool asks_for_ball(const PlacementRequest& asked, const PlacementRequest& shown) {
  return !bit_equal(asked.ball_x, shown.ball_x) || !bit_equal(asked.ball_y, shown.ball_y);
}

}  // namespace

PlacementRequest unchanged_request(const Observation& observation) {
  PlacementRequest poses{
      .ball_x = observation.ball.x(), .ball_y = observation.ball.y(), .robots = {}};
  for (int i = 0; i < observation.robots; ++i) {
    const ObservedRobot& robot = observation.own[i];
    poses.robots[i] = {robot.position.x(), robot.position.y(), robot.heading};
  }
  return poses;
}

bool bit_equal(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool bit_equal(const RequestedPose& a, const RequestedPose& b) {
  return bit_equal(a.x, b.x) && bit_equal(a.y, b.y) && bit_equal(a.heading, b.heading);
}

bool bit_equal(const PlacementRequest& a, const PlacementRequest& b, int robots) {
  for (int i = 0; i < robots; ++i) {
    if (!bit_equal(a.robots[i], b.robots[i])) return false;
  }
  return bit_equal(a.ball_x, b.ball_x) && bit_equal(a.ball_y, b.ball_y);
}

PlacementRequest rounded(const PlacementRequest& asked, const PlacementRequest& shown, int robots) {
  PlacementRequest result = asked;
  if (asks_for_ball(asked, shown)) {
    result.ball_x = to_steps(asked.ball_x);
    result.ball_y = to_steps(asked.ball_y);
  }
  for (int i = 0; i < robots; ++i) {
    const RequestedPose& pose = asked.robots[i];
    if (bit_equal(pose, shown.robots[i])) continue;
    result.robots[i] = {to_steps(pose.x), to_steps(pose.y), to_steps(pose.heading)};
  }
  return result;
}

referee::Placement requested_placement(const referee::Placement& standing, End end,
                                       const PlacementRequest& shown, const PlacementRequest& asked,
                                       int robots) {
  referee::Placement placement = standing;
  if (asks_for_ball(asked, shown)) {
    placement.ball = team_frame(end, Vec2{asked.ball_x, asked.ball_y});
  }
  for (int i = 0; i < robots; ++i) {
    if (bit_equal(asked.robots[i], shown.robots[i])) continue;
    placement.robots[index_of(end)][i] = to_pose(asked.robots[i], end);
  }
  return placement;
}

}  // namespace mirocup::match
