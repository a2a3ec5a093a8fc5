// SPDX-License-Identifier: MIT
#include "plugins/abi/convert.hpp"

#include "core/match/copy_fields.hpp"
#include "core/match/thought.hpp"

#include <algorithm>
#include <iterator>

namespace mirocup::abi {

// The core and strategy.h give these the same numbers.
static_assert(static_cast<int>(RobotLeague::large) == MIROCUP_LARGE);
static_assert(static_cast<int>(Team::yellow) == MIROCUP_YELLOW);
static_assert(static_cast<int>(match::State::END) == MIROCUP_OVER);
static_assert(static_cast<int>(referee::Phase::SECOND_HALF) == MIROCUP_SECOND_HALF);
static_assert(static_cast<int>(referee::Phase::SHOOT_OUT) == MIROCUP_SHOOT_OUT);
static_assert(static_cast<int>(referee::Restart::KICK_OFF) == MIROCUP_KICK_OFF);
static_assert(static_cast<int>(referee::Restart::GOAL_KICK) == MIROCUP_GOAL_KICK);
static_assert(static_cast<int>(referee::Restart::PENALTY_KICK) == MIROCUP_PENALTY_KICK);
static_assert(static_cast<int>(referee::Restart::FREE_BALL) == MIROCUP_FREE_BALL);
static_assert(static_cast<int>(referee::Restart::FREE_KICK) == MIROCUP_FREE_KICK);
static_assert(max_robots_per_team == MIROCUP_MAX_ROBOTS);
static_assert(MIROCUP_LAWS <= MIROCUP_MAX_LAWS);

namespace {

mirocup_robot to_robot(const match::ObservedRobot& robot) {
  return {robot.position.x(), robot.position.y(), robot.heading,
          robot.velocity.x(), robot.velocity.y(), robot.turn};
}

static_assert(geometry::max_corners == MIROCUP_MAX_CORNERS);
static_assert(match::max_polygon_corners == MIROCUP_MAX_POLYGON_CORNERS);

void copy_physics(const simulator::Parameters& p, mirocup_setup& s) {
  s.turn_time_constant = p.turn_lag();
  s.brake_time_constant = p.brake_lag();
  s.rolling_resistance = p.rolling_resistance;
  s.viscous_friction = p.viscous_friction;
  s.ball_wall_restitution = p.restitution.ball_wall;
  s.ball_robot_restitution = p.restitution.ball_robot;
  s.robot_wall_restitution = p.restitution.robot_wall;
  s.robot_robot_restitution = p.restitution.robot_robot;
  s.ball_wall_friction = p.contact_friction.ball_wall;
  s.ball_robot_friction = p.contact_friction.ball_robot;
  s.robot_wall_friction = p.contact_friction.robot_wall;
  s.robot_robot_friction = p.contact_friction.robot_robot;
  s.corners = p.robot_corners.corners;
  for (int c = 0; c < s.corners; ++c) {
    s.corner_x[c] = p.robot_corners.x[c];
    s.corner_y[c] = p.robot_corners.y[c];
  }
}

void copy_limits(const referee::Rules& rules, mirocup_setup& s) {
  s.stalemate_limit_s = rules.stalemate_s;
  s.advantage_limit_s = rules.advantage_s;
  std::fill(std::begin(s.time_limit_s), std::end(s.time_limit_s), referee::off);
  s.time_limit_s[MIROCUP_TWO_DEFENDERS] = rules.def_dwell_s;
  s.time_limit_s[MIROCUP_FOUR_DEFENDERS] = rules.def_dwell_s;
  s.time_limit_s[MIROCUP_TWO_ATTACKERS] = rules.att_dwell_s;
  s.time_limit_s[MIROCUP_KEEPER_HOLD] = rules.keeper_hold_s;
  s.robots_allowed[MIROCUP_TWO_DEFENDERS] = rules.def_max;
  s.robots_allowed[MIROCUP_FOUR_DEFENDERS] = rules.pa_def_max;
  s.robots_allowed[MIROCUP_TWO_ATTACKERS] = rules.att_max;
}

void copy_counts(const referee::TeamCounts& from, mirocup_counts& c) {
  c.time_s[MIROCUP_TWO_DEFENDERS] = from.two_defenders_s;
  c.time_s[MIROCUP_FOUR_DEFENDERS] = from.four_defenders_s;
  c.time_s[MIROCUP_TWO_ATTACKERS] = from.two_attackers_s;
  c.time_s[MIROCUP_KEEPER_HOLD] = from.keeper_hold_s;
  c.robots[MIROCUP_TWO_DEFENDERS] = from.defenders;
  c.robots[MIROCUP_FOUR_DEFENDERS] = from.area_defenders;
  c.robots[MIROCUP_TWO_ATTACKERS] = from.attackers;
  c.keeper = from.keeper;
  c.advantage_against = from.advantage_against ? 1 : 0;
}

}  // namespace

mirocup_setup to_setup(const match::Briefing& briefing) {
  const field::Field& field = *briefing.field;
  mirocup_setup s{};
  s.size = sizeof s;
  s.command_size = sizeof(mirocup_command);
  s.placement_size = sizeof(mirocup_placement);
  s.league = static_cast<int>(field.league);
  s.team = index_of(briefing.team);
  s.robots = field.robots_per_team;
  s.laws = MIROCUP_LAWS;
  s.seed = briefing.seed;
  s.control_period = briefing.control_period;
  s.half_s = briefing.rules->half_s;
  s.ready_s = briefing.rules->ready_s;
  match::copy_field(field, s);
  match::copy_bodies(*briefing.parameters, s);
  copy_physics(*briefing.parameters, s);
  copy_limits(*briefing.rules, s);
  return s;
}

mirocup_observation to_observation(const match::Observation& from) {
  mirocup_observation o{};
  o.size = sizeof o;
  o.tick = from.tick;
  o.time = from.time;
  o.clock = from.clock;
  o.state = static_cast<int>(from.state);
  o.phase = static_cast<int>(from.phase);
  o.restart = static_cast<int>(from.restart);
  o.own_restart = from.own_restart ? 1 : 0;
  o.own_score = from.own_score;
  o.opponent_score = from.opponent_score;
  o.robots = from.robots;
  o.laws = MIROCUP_LAWS;
  o.placing = from.placing ? 1 : 0;
  o.ball_x = from.ball.x();
  o.ball_y = from.ball.y();
  o.ball_vx = from.ball_velocity.x();
  o.ball_vy = from.ball_velocity.y();
  for (int i = 0; i < from.robots; ++i) {
    o.own[i] = to_robot(from.own[i]);
    o.opponent[i] = to_robot(from.opponent[i]);
    o.own_age_ticks[i] = from.own[i].age;
    o.opponent_age_ticks[i] = from.opponent[i].age;
  }
  o.ball_age_ticks = from.ball_age;
  copy_counts(from.own_counts, o.own_counts);
  copy_counts(from.opponent_counts, o.opponent_counts);
  o.stalemate_s = from.stalemate_s;
  o.advantage_s = from.advantage_s;
  return o;
}

match::Command to_command(const mirocup_command& from) {
  match::Command command;
  for (int i = 0; i < max_robots_per_team; ++i) {
    command.wheels[i] = {from.wheels[i].left, from.wheels[i].right};
  }
  return command;
}

match::PlacementRequest to_poses(const mirocup_placement& from) {
  match::PlacementRequest poses{.ball_x = from.ball_x, .ball_y = from.ball_y, .robots = {}};
  for (int i = 0; i < max_robots_per_team; ++i) {
    poses.robots[i] = {from.robots[i].x, from.robots[i].y, from.robots[i].heading};
  }
  return poses;
}

}  // namespace mirocup::abi
