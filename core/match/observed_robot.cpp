// SPDX-License-Identifier: MIT
#include "core/match/observed_robot.hpp"

#include <cmath>

namespace mirocup::match {

namespace {

constexpr double steps_per_radian = 0x1p50;

double rounded(double angle) {
  return std::nearbyint(angle * steps_per_radian) / steps_per_radian;
}

}  // namespace

double half_turned(double angle) {
  return angle <= 0.0 ? angle + pi : angle - pi;
}

// Rounds the angle of a heading towards +x, and turns it afterwards: the angles of two opposite
// headings then differ by exactly pi.
double observed_angle(const Heading& heading) {
  if (heading.cos >= 0.0) return rounded(heading.angle());
  return half_turned(rounded(heading.half_turned().angle()));
}

double observed_angle(double angle) {
  constexpr double turn = 2.0 * pi;  // a multiple of 2^-50, too: subtracting it is exact
  double result = rounded(angle);
  while (result > pi) result -= turn;
  while (result <= -pi) result += turn;
  return result;
}

ObservedRobot observed(const simulator::BodyState& robot) {
  return {.position = robot.position,
          .heading = observed_angle(robot.heading),
          .velocity = robot.heading.to_world({robot.twist.forward, robot.twist.left}),
          .turn = robot.twist.omega};
}

ObservedRobot team_frame(End end, const ObservedRobot& robot) {
  return {.position = mirocup::team_frame(end, robot.position),
          .heading = end == End::left ? robot.heading : half_turned(robot.heading),
          .velocity = mirocup::team_frame(end, robot.velocity),
          .turn = robot.turn,
          .age = robot.age};
}

}  // namespace mirocup::match
