// SPDX-License-Identifier: MIT
//
// Closed form: the motion of a robot that can touch nothing and whose wheels cannot slide.
//
// Its speeds are exponentials and its heading is their integral, in closed form. Its path is one
// smooth integral, computed by Gauss-Legendre quadrature with eight nodes. The result is exact to
// rounding for the turns that has_closed_form() allows, at a tenth of the cost of a series.
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

// e^(-t/T) at the nodes of the quadrature over [0, span] and at its end: the same for all robots
// whose motors have that T.
struct MotorDecay {
  double span = -1.0;          // s
  double time_constant = 0.0;  // T, s
  std::array<double, gauss_nodes> at_node;
  double at_end = 1.0;
};
// Returns the decay with that time constant, s, over `span` seconds.
MotorDecay motor_decay(double time_constant, double span);

// The decays of a robot's forward speed and of its angular velocity, over the same span. They are
// the same object if the motors have one lag.
struct DriveDecay {
  const MotorDecay& forward;
  const MotorDecay& turn;
};

// True if the closed form holds for a robot over `span` seconds: its wheels roll and will roll, and
// it does not turn too far for the quadrature. Contacts are the caller's concern.
bool has_closed_form(const Parameters& parameters, const BodyState& robot,
                     const DriveReference& drive, double span);

// Returns the state of the robot at the end of `decay`'s span. Precondition: has_closed_form().
BodyState closed_form_state(const BodyState& robot, const DriveReference& drive,
                            const DriveDecay& decay);
// The same state after `span` seconds, for a caller that has no decays.
BodyState closed_form_state(const BodyState& robot, const DriveReference& drive, double span);

// Returns the largest magnitude of a speed on its way from `now` to `aim`, the speed that the
// motors aim at. The speed changes monotonically, so this is the magnitude of one of the two.
inline double fastest(double now, double aim) {
  return std::max(std::abs(now), std::abs(aim));
}

// The two functions below are inline because every robot needs them in every tick: returning their
// structs through memory causes store-forwarding stalls (scalar stores, then vector loads).

// Returns a box that holds the robot's centre from `robot` to `end`, the state that
// closed_form_state() returned. A path of length l lies within l/2 of the middle between its ends.
// `decay` is that of the forward speed.
inline Box closed_form_box(const BodyState& robot, const BodyState& end,
                           const DriveReference& drive, const MotorDecay& decay) {
  const double now = robot.twist.forward;
  const double aim = drive.forward;
  const bool turns_back = now * aim < 0.0;
  const double length =
      turns_back
          ? decay.span * fastest(now, aim)
          : std::abs(aim * decay.span + (now - aim) * decay.time_constant * (1.0 - decay.at_end));
  const double reach = 0.5 * length * (1.0 + settings::closed_form.box_margin);
  const Vec2 middle = 0.5 * (robot.position + end.position);
  return {middle.x() - reach, middle.x() + reach, middle.y() - reach, middle.y() + reach};
}

// Returns the bound of the motion from `robot` to `end`, which starts at `begin`, s of the tick.
// `decay` is that of the forward speed.
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
