// SPDX-License-Identifier: MIT
//
// A robot alone: differential drive with first-order motors, and wheels that can slide sideways.
//
//   dv_f/dt = (v_ref - v_f)/T + omega v_l
//   dv_l/dt = f_g/M           - omega v_f
//   domega/dt = (omega_ref - omega)/T                                   (1) to (3), errata in
//   core/README.md
//
// f_g is the ground's sideways force, |f_g| <= grip M g. While the wheels roll (v_l = 0) it is what
// keeps v_l = 0; while they slide it is -grip M g sign(v_l). Where one turns into the other a
// segment ends.
#pragma once

#include "core/simulator/model/parameters.hpp"
#include "core/simulator/trajectory/segment.hpp"

namespace mirocup::simulator::trajectory {

// What the motors aim at until the next command.
struct DriveReference {
  bool wheels_on_ground = true;  // false: a free body without motor and grip
  double forward = 0.0;          // v_ref, m/s
  double omega = 0.0;            // omega_ref, rad/s
};

// The drive of a command: clamped to the wheel speed limit.
DriveReference drive_reference(const Parameters& parameters, const WheelCommand& command);

// Slower sideways motion than this (m/s) is rounding of wheels that roll.
inline constexpr double slip_round_off = 1e-13;

// How the wheels touch the ground.
enum class WheelState { rolling, sliding, lifted };

// WheelState slide if v_l is not zero, or if the turn needs more than the grip.
WheelState wheel_state(const Parameters& parameters, const BodyState& robot,
                       const DriveReference& drive);

// One more term of the twist from the terms up to k, without contacts. `slide` is +1 for wheels
// that slide to the left, -1 to the right, 0 for wheels that roll.
void extend_twist_on_ground(const Parameters& parameters, const DriveReference& drive, double slide,
                            int k, Segment& segment);
void extend_twist_lifted(int k, Segment& segment);

// Sideways acceleration beyond which the grip is lost, m/s^2. It is a hair more than grip g, so
// that the sliding that follows has a direction in spite of rounding.
inline constexpr double grip_margin = 1e-7;
inline double lateral_acceleration_limit(const Parameters& parameters) {
  return parameters.grip * gravity * (1.0 + grip_margin);
}

// When wheels that slide grip again: v_l of `segment` comes back to zero. Seconds from its begin,
// or never.
double time_of_grip(const Segment& segment, double slide);

// The motion from `begin` (seconds of the tick) until the wheels begin or cease to slide, the
// series ends, or `horizon`.
Segment drive(const Parameters& parameters, const BodyState& robot, const DriveReference& drive,
              double begin, double horizon, double preferred_duration);

}  // namespace mirocup::simulator::trajectory
