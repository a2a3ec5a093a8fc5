// SPDX-License-Identifier: MIT
//
// A robot that can touch nothing and whose wheels cannot slide: where it will be, without a series.
//
// Speeds are exponentials and the heading is their integral, in closed form; the way is one smooth
// integral, done by Gauss's rule, exact to rounding for the turns that are let in here. It costs a
// tenth of the series that contacts need.
#pragma once

#include "core/base/math.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/trajectory/differential_drive.hpp"
#include "core/simulator/trajectory/motion_bound.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::simulator::trajectory {

inline constexpr int gauss_nodes = angles_at_once;

// e^(-t/T) at the nodes of Gauss's rule over [0, span] and at its end: the same for all robots.
struct MotorDecay {
  double span = -1.0;  // s
  double time_constant = 0.0;
  std::array<double, gauss_nodes> at_node;
  double at_end = 1.0;
};
MotorDecay motor_decay(const Parameters& parameters, double span);

// Can the robot's motion over `span` seconds be had this way? The wheels roll and will roll, and it
// does not turn too far for the rule.
bool has_closed_form(const Parameters& parameters, const BodyState& robot,
                     const DriveReference& drive, double span);

// The robot after decay.span seconds.
BodyState closed_form_state(const BodyState& robot, const DriveReference& drive,
                            const MotorDecay& decay);

// The faster of a speed now and what the motors aim at.
inline double fastest(double now, double aim) {
  return std::max(std::abs(now), std::abs(aim));
}

// Where it is meanwhile. Every robot in every tick has these, so they are inline: what comes back by
// memory is written by single numbers, read by twos, and has to be waited for.

// A box that holds its centre on the way from `robot` to `end`, as moved() gave it: a way of length l
// lies within l/2 of the middle between its ends.
inline Box closed_form_box(const BodyState& robot, const BodyState& end,
                           const DriveReference& drive, const MotorDecay& decay) {
  const double now = robot.twist.forward;
  const double aim = drive.forward;
  const bool turns_back = now * aim < 0.0;
  const double way =
      turns_back
          ? decay.span * fastest(now, aim)
          : std::abs(aim * decay.span + (now - aim) * decay.time_constant * (1.0 - decay.at_end));
  const double reach = 0.5 * way * (1.0 + 1e-9);
  const Vec2 middle = 0.5 * (robot.position + end.position);
  return {middle.x() - reach, middle.x() + reach, middle.y() - reach, middle.y() + reach};
}

// The same as a way that begins at `begin`, s of the tick.
inline MotionBound closed_form_bound(const BodyState& robot, const BodyState& end,
                                     const DriveReference& drive, const MotorDecay& decay,
                                     double begin) {
  const double turn = fastest(robot.twist.omega, drive.omega);
  const double along = (drive.forward - robot.twist.forward) / decay.time_constant;
  const double across = fastest(robot.twist.forward, drive.forward) * turn;
  const double acceleration = std::sqrt(along * along + across * across);
  return bound_between(robot.position, end.position, begin, decay.span, acceleration, turn);
}

}  // namespace mirocup::simulator::trajectory
