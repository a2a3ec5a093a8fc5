// SPDX-License-Identifier: MIT
//
// Copies between the structs of core, of strategy.h and of the DDS topics, which give the same
// values the same names. A field that is added here must be added to all of these structs.
#pragma once

#include "core/field/field.hpp"

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

// Calls visit(name, member) for each limit in referee::Rules that a team receives.
template <class Rules, class Visit>
void for_each_limit(Rules& rules, Visit visit) {
  visit("stalemate_limit_s", rules.stalemate_s);
  visit("advantage_limit_s", rules.advantage_s);
  visit("keeper_hold_limit_s", rules.keeper_hold_s);
  visit("defenders_limit_s", rules.def_dwell_s);
  visit("attackers_limit_s", rules.att_dwell_s);
  visit("ready_s", rules.ready_s);
  visit("defenders_allowed", rules.def_max);
  visit("area_defenders_allowed", rules.pa_def_max);
  visit("attackers_allowed", rules.att_max);
}

// Calls visit(name, member) for each number of simulator::Parameters that a team receives and that
// copy_bodies() leaves out: the motors' other lags (0: none), the floor and the contacts.
template <class P, class Visit>
void for_each_physics(P& p, Visit visit) {
  visit("turn_time_constant", p.turn_time_constant);
  visit("brake_time_constant", p.brake_time_constant);
  visit("rolling_resistance", p.rolling_resistance);
  visit("viscous_friction", p.viscous_friction);
  visit("ball_wall_restitution", p.restitution.ball_wall);
  visit("ball_robot_restitution", p.restitution.ball_robot);
  visit("robot_wall_restitution", p.restitution.robot_wall);
  visit("robot_robot_restitution", p.restitution.robot_robot);
  visit("ball_wall_friction", p.contact_friction.ball_wall);
  visit("ball_robot_friction", p.contact_friction.ball_robot);
  visit("robot_wall_friction", p.contact_friction.robot_wall);
  visit("robot_robot_friction", p.contact_friction.robot_robot);
}

// Copies the sizes of a field::Field that a team receives.
template <class To>
void copy_field(const field::Field& field, To& to) {
  to.half_length = field.half_length;
  to.half_width = field.half_width;
  to.corner_leg = field.corner_leg;
  to.goal_half_width = field.goal_half_width;
  to.goal_depth = field.goal_depth;
  to.goal_area_depth = field.goal_area.depth;
  to.goal_area_half_width = field.goal_area.half_width;
  if (field.penalty_area) {
    to.penalty_area_depth = field.penalty_area->depth;
    to.penalty_area_half_width = field.penalty_area->half_width;
  }
  to.centre_circle_radius = field.centre_circle_radius;
}

// Copies the referee's pending counts about a team. The two structs have integers of different
// types, and `advantage_against` is a number in one of them and a bool in the other.
template <class From, class To>
void copy_counts(const From& from, To& to) {
  to.defenders = static_cast<decltype(to.defenders)>(from.defenders);
  to.two_defenders_s = from.two_defenders_s;
  to.area_defenders = static_cast<decltype(to.area_defenders)>(from.area_defenders);
  to.four_defenders_s = from.four_defenders_s;
  to.attackers = static_cast<decltype(to.attackers)>(from.attackers);
  to.two_attackers_s = from.two_attackers_s;
  to.keeper_hold_s = from.keeper_hold_s;
  to.keeper = static_cast<decltype(to.keeper)>(from.keeper);
  to.advantage_against = static_cast<decltype(to.advantage_against)>(from.advantage_against);
}

}  // namespace mirocup::match
