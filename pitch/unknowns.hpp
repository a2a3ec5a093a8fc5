// SPDX-License-Identifier: MIT
//
// The numbers that can be identified from a recording: those of the model, and the delay of
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
  double command_delay = 0.0;  // s, from the time at which a command was sent to its first effect
};

// One number of a pitch.
struct Unknown {
  std::string_view name;   // "wheel_radius", "restitution/ball_wall", "command_delay"
  bool is_ratio;           // found as a logarithm: it is positive, and its interval is a factor
  double least, most;      // its range
  double widest;           // a number whose 95 % interval has a larger half-width is not known;
                           // of the logarithm if is_ratio, otherwise of the number
  std::string_view needs;  // the motion that a recording needs to tell it
};

inline constexpr int unknown_count = 13;
// Indices of unknowns to which other sources refer.
inline constexpr int motor_lag = 2, turn_lag = 3, brake_lag = 4, grip_limit = 5;
inline constexpr int rolling_resistance = 6, viscous_friction = 7;
inline constexpr int ball_on_wall = 8, ball_on_robot = 9, robot_on_wall = 10, robot_on_robot = 11;

const std::array<Unknown, unknown_count>& unknowns();

// value_of() returns the number, set_value() sets it, clamped to its range. If is_ratio, both take
// its logarithm instead.
double value_of(const Guess& guess, int unknown);
void set_value(Guess& guess, int unknown, double value);

}  // namespace mirocup::pitch
