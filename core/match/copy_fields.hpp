// SPDX-License-Identifier: MIT
//
// Copies between structs of different rooms that give the same things the same names: those of the
// match, of strategy.h and of the DDS topics. A field that is added here must be added to all of
// them.
#pragma once

namespace mirocup::match {

// Copies the sizes and limits of robots and ball that a team receives.
template <class From, class To>
void copy_bodies(const From& from, To& to) {
  to.robot_side = from.robot_side;
  to.robot_mass = from.robot_mass;
  to.wheel_distance = from.wheel_distance;
  to.wheel_radius = from.wheel_radius;
  to.wheel_speed_limit = from.wheel_speed_limit;
  to.motor_time_constant = from.motor_time_constant;
  to.grip = from.grip;
  to.ball_radius = from.ball_radius;
  to.ball_mass = from.ball_mass;
}

// Copies the referee's pending counts about a team.
template <class From, class To>
void copy_counts(const From& from, To& to) {
  to.defenders = from.defenders;
  to.two_defenders_s = from.two_defenders_s;
  to.area_defenders = from.area_defenders;
  to.four_defenders_s = from.four_defenders_s;
  to.attackers = from.attackers;
  to.two_attackers_s = from.two_attackers_s;
  to.keeper_hold_s = from.keeper_hold_s;
  to.keeper = from.keeper;
  // A number on one side, a bool on the other.
  to.advantage_against = static_cast<decltype(to.advantage_against)>(from.advantage_against);
}

}  // namespace mirocup::match
