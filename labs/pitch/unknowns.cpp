// SPDX-License-Identifier: MIT
#include "labs/pitch/unknowns.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::pitch {

namespace {

double& number_of(Guess& guess, int unknown) {
  simulator::Parameters& p = guess.parameters;
  double* const numbers[unknown_count] = {
      &p.wheel_radius,           &p.wheel_distance,         &p.motor_time_constant,
      &p.turn_time_constant,     &p.brake_time_constant,    &p.grip,
      &p.rolling_resistance,     &p.viscous_friction,       &p.restitution.ball_wall,
      &p.restitution.ball_robot, &p.restitution.robot_wall, &p.restitution.robot_robot,
      &guess.command_delay};
  return *numbers[unknown];
}

}  // namespace

const std::array<Unknown, unknown_count>& unknowns() {
  static constexpr std::array<Unknown, unknown_count> all{{
      {"wheel_radius", true, 1e-3, 0.1, 0.25, "robots that drive by known commands"},
      {"wheel_distance", true, 1e-2, 0.3, 0.25, "robots that turn by known commands"},
      {"motor_time_constant", true, 2e-3, 2.0, 0.5, "robots whose speed changes by commands"},
      {"turn_time_constant", true, 2e-3, 2.0, 0.5, "robots whose turn rate changes by commands"},
      {"brake_time_constant", true, 2e-3, 2.0, 0.5, "driving robots that are commanded 0, 0"},
      {"grip", true, 0.05, 5.0, 0.5, "wheels that slide sideways in hard turns"},
      {"rolling_resistance", false, 0.0, 0.5, 0.02, "a ball that rolls freely"},
      {"viscous_friction", false, 0.0, 1.0, 0.05, "a ball that rolls freely at several speeds"},
      {"restitution/ball_wall", false, 0.0, 1.0, 0.2, "a ball that hits a wall"},
      {"restitution/ball_robot", false, 0.0, 1.0, 0.2, "a ball that hits a robot"},
      {"restitution/robot_wall", false, 0.0, 1.0, 0.2, "a robot that hits a wall"},
      {"restitution/robot_robot", false, 0.0, 1.0, 0.2, "robots that hit each other"},
      {"command_delay", false, 0.0, 0.5, 0.02, "robots whose commands change"},
  }};
  return all;
}

double value_of(const Guess& guess, int unknown) {
  Guess copy = guess;
  const double number = number_of(copy, unknown);
  return unknowns()[unknown].is_ratio ? std::log(number) : number;
}

void set_value(Guess& guess, int unknown, double value) {
  const Unknown& u = unknowns()[unknown];
  number_of(guess, unknown) = std::clamp(u.is_ratio ? std::exp(value) : value, u.least, u.most);
}

}  // namespace mirocup::pitch
