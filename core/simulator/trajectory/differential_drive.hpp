// SPDX-License-Identifier: MIT
//
// A robot alone: differential drive with first-order motors, and wheels that can slide sideways.
//
//   dv_f/dt   = (v_ref - v_f)/T_f + omega v_l
//   dv_l/dt   = f_g/M             - omega v_f
//   domega/dt = (omega_ref - omega)/T_w           (1) to (3), errata in docs/model.md
//
// T_f and T_w are one constant, as in the paper, unless the pitch gives turning or braking a lag of
// its own. DriveReference holds both for one command; they are constant until the next command.
//
// f_g is the ground's lateral force on the wheels, |f_g| <= grip M g. While the wheels roll, v_l
// = 0 and f_g is the force that keeps it zero. While they slide, f_g is -grip M g sign(v_l). A
// segment ends where the wheels change between rolling and sliding.
#pragma once

#include "core/simulator/model/parameters.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <algorithm>

namespace mirocup::simulator::trajectory {

// The speeds that the motors aim at until the next command.
struct DriveReference {
  bool wheels_on_ground = true;  // false: a free body without motor and grip
  double forward = 0.0;          // v_ref, m/s
  double omega = 0.0;            // omega_ref, rad/s
  double forward_lag = 1.0;      // T_f, s
  double turn_lag = 1.0;         // T_w, s

  // Returns the fastest rate at which a motor follows, 1/s.
  double rate() const { return 1.0 / std::min(forward_lag, turn_lag); }
};

// Returns the drive reference of a command, whose speeds are clamped to the wheel speed limit. For
// the command (0, 0) the forward lag is Parameters::brake_lag().
DriveReference drive_reference(const Parameters& parameters, const WheelCommand& command);

// The contact of the wheels with the ground.
enum class WheelState { rolling, sliding, lifted };

// Returns the state of a robot's wheels. Wheels slide if v_l is not zero, or if the turn needs more
// than the grip.
WheelState wheel_state(const Parameters& parameters, const BodyState& robot,
                       const DriveReference& drive);

// Add term k + 1 of the twist, from the terms of the twist up to k, for a robot without contacts.
// `slide` is +1 for wheels that slide to the left, -1 to the right, 0 for wheels that roll.
void extend_twist_on_ground(const Parameters& parameters, const DriveReference& drive, double slide,
                            int k, Segment& segment);
void extend_twist_lifted(int k, Segment& segment);

// Returns the lateral acceleration beyond which the wheels lose their grip, m/s^2.
inline double lateral_acceleration_limit(const Parameters& parameters) {
  return parameters.grip * gravity * (1.0 + settings::differential_drive.grip_margin);
}

// Returns the time at which sliding wheels grip again, because v_l of `segment` returns to zero: s
// since the start of the segment, or `never`.
double time_of_grip(const Segment& segment, double slide);

// Returns the motion of a robot without contacts from `begin`, s of the tick. It ends at `horizon`,
// s of the tick, or before: where the wheels begin or cease to slide, or where the series no longer
// converge. `preferred_duration`, s, is the time for which the series should hold (fill_series()).
Segment drive(const Parameters& parameters, const BodyState& robot, const DriveReference& drive,
              double begin, double horizon, double preferred_duration);

}  // namespace mirocup::simulator::trajectory
