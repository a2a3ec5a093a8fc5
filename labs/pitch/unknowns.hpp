// SPDX-License-Identifier: MIT
//
// The numbers that can be identified from a recording: numbers of the model, and the delay of
// commands.
#pragma once

#include "core/simulator/model/parameters.hpp"

#include <array>
#include <string>
#include <string_view>

namespace mirocup::pitch {

// A pitch while it is being identified.
struct Guess {
  simulator::Parameters parameters;
  double command_delay = 0.0;  // time from the sending of a command to its first effect, s
};

// One number of a pitch.
struct Unknown {
  std::string_view name;  // "wheel_radius", "restitution/ball_wall", "command_delay"
  // True: the number is positive, and the fit searches its logarithm.
  bool is_ratio;
  double least, most;  // range of the number
  // A number is known if half its 95 % interval, of the logarithm if is_ratio, is less than this.
  double widest;
  std::string_view needs;  // the motion that a recording must show to identify the number
};

inline constexpr int unknown_count = 13;
// Indices of the unknowns that other source files use.
inline constexpr int motor_lag = 2, turn_lag = 3, brake_lag = 4, grip_limit = 5;
inline constexpr int rolling_resistance = 6, viscous_friction = 7;
inline constexpr int ball_on_wall = 8, ball_on_robot = 9, robot_on_wall = 10, robot_on_robot = 11;

const std::array<Unknown, unknown_count>& unknowns();

// value_of() returns the number, set_value() sets the number, clamped to its range. If is_ratio,
// both functions use its logarithm instead.
double value_of(const Guess& guess, int unknown);
void set_value(Guess& guess, int unknown, double value);

}  // namespace mirocup::pitch
