// SPDX-License-Identifier: MIT
#include "server/dds/convert.hpp"

#include <cmath>

namespace mirocup::dds {

static_assert(max_robots_per_team == mirocup_v1_MAX_ROBOTS);

namespace {

mirocup_v1_RobotState to_sample(const simulator::RobotState& r) {
  return {r.position.x(),  r.position.y(), r.heading.cos, r.heading.sin,
          r.twist.forward, r.twist.left,   r.twist.turn};
}

simulator::RobotState to_robot(const mirocup_v1_RobotState& r) {
  return {{r.x, r.y}, {r.heading_cos, r.heading_sin}, {r.forward, r.left, r.turn}};
}

mirocup_v1_TeamCounts to_sample(const referee::TeamCounts& c) {
  return {c.defenders,       c.two_defenders_s, c.area_defenders, c.four_defenders_s, c.attackers,
          c.two_attackers_s, c.keeper_hold_s,   c.keeper,         c.advantage_against};
}

referee::TeamCounts to_counts(const mirocup_v1_TeamCounts& c) {
  return {c.defenders,       c.two_defenders_s, c.area_defenders, c.four_defenders_s, c.attackers,
          c.two_attackers_s, c.keeper_hold_s,   c.keeper,         c.advantage_against};
}

template <class E>
std::uint8_t octet(E value) {
  return static_cast<std::uint8_t>(value);
}

// Numbers from the network: what is out of range counts as 0.
template <class E>
E enumerator(std::uint8_t value) {
  return value < enum_names<E>.size() ? static_cast<E>(value) : E{};
}

}  // namespace

mirocup_v1_WorldState to_sample(const match::Scene& scene, int robots) {
  mirocup_v1_WorldState s{};
  s.tick = scene.tick;
  s.time = scene.time;
  s.clock = scene.clock;
  s.state = octet(scene.state);
  s.phase = octet(scene.phase);
  s.restart = octet(scene.restart);
  s.taker = octet(scene.taker);
  s.left = octet(scene.left);
  s.robots = static_cast<std::uint8_t>(robots);
  s.score[0] = scene.score[0];
  s.score[1] = scene.score[1];
  s.ball_x = scene.ball.position.x();
  s.ball_y = scene.ball.position.y();
  s.ball_vx = scene.ball.velocity.x();
  s.ball_vy = scene.ball.velocity.y();
  for (int i = 0; i < robots; ++i) {
    s.blue[i] = to_sample(scene.robots[0][i]);
    s.yellow[i] = to_sample(scene.robots[1][i]);
  }
  s.stalemate_s = scene.stalemate_s;
  s.advantage_s = scene.advantage_s;
  for (int team = 0; team < 2; ++team) s.counts[team] = to_sample(scene.counts[team]);
  return s;
}

match::Scene to_scene(const mirocup_v1_WorldState& s) {
  match::Scene scene;
  scene.tick = s.tick;
  scene.time = s.time;
  scene.clock = s.clock;
  scene.state = enumerator<match::State>(s.state);
  scene.phase = enumerator<referee::Phase>(s.phase);
  scene.restart = enumerator<referee::Restart>(s.restart);
  scene.taker = enumerator<Team>(s.taker);
  scene.left = enumerator<Team>(s.left);
  scene.score = {s.score[0], s.score[1]};
  scene.ball = {{s.ball_x, s.ball_y}, {s.ball_vx, s.ball_vy}};
  for (int i = 0; i < max_robots_per_team; ++i) {
    scene.robots[0][i] = to_robot(s.blue[i]);
    scene.robots[1][i] = to_robot(s.yellow[i]);
  }
  scene.stalemate_s = s.stalemate_s;
  scene.advantage_s = s.advantage_s;
  for (int team = 0; team < 2; ++team) scene.counts[team] = to_counts(s.counts[team]);
  return scene;
}

mirocup_v1_Welcome to_sample(const match::Briefing& briefing, std::uint64_t nonce) {
  const simulator::Parameters& p = *briefing.parameters;
  mirocup_v1_Welcome w{};
  w.team = octet(briefing.team);
  w.nonce = nonce;
  w.accepted = true;
  w.league = octet(briefing.field->league);
  w.seed = briefing.seed;
  w.control_period = briefing.control_period;
  w.half_seconds = briefing.rules->half_s;
  w.robot_side = p.robot_side;
  w.robot_mass = p.robot_mass;
  w.wheel_distance = p.wheel_distance;
  w.wheel_radius = p.wheel_radius;
  w.wheel_speed_limit = p.wheel_speed_limit;
  w.motor_time_constant = p.motor_time_constant;
  w.grip = p.grip;
  w.ball_radius = p.ball_radius;
  w.ball_mass = p.ball_mass;
  return w;
}

bool from_sample(const mirocup_v1_Welcome& w, Told& told) {
  if (w.league >= enum_names<League>.size() || w.team >= enum_names<Team>.size()) return false;
  told.field = field::make_field(static_cast<League>(w.league));
  simulator::Parameters& p = told.parameters;
  p.robot_side = w.robot_side;
  p.robot_mass = w.robot_mass;
  p.wheel_distance = w.wheel_distance;
  p.wheel_radius = w.wheel_radius;
  p.wheel_speed_limit = w.wheel_speed_limit;
  p.motor_time_constant = w.motor_time_constant;
  p.grip = w.grip;
  p.ball_radius = w.ball_radius;
  p.ball_mass = w.ball_mass;
  told.rules.half_s = w.half_seconds;
  told.briefing = {.field = &told.field,
                   .parameters = &told.parameters,
                   .rules = &told.rules,
                   .control_period = w.control_period,
                   .team = static_cast<Team>(w.team),
                   .seed = w.seed};
  return true;
}

mirocup_v1_MatchEvent to_sample(const match::LoggedDecision& d, std::uint32_t number,
                                const match::ByTeam<int>& score) {
  mirocup_v1_MatchEvent e{};
  e.number = number;
  e.tick = d.tick;
  e.clock = d.decision.clock;
  put_text(e.decision, to_string(d.decision.verdict));
  put_text(e.law, to_string(d.decision.law));
  put_text(e.reason, d.decision.reason);
  e.score[0] = score[0];
  e.score[1] = score[1];
  return e;
}

mirocup_v1_TeamCommand to_sample(const match::Command& command, Team team, std::uint32_t tick,
                                 std::uint64_t nonce) {
  mirocup_v1_TeamCommand s{};
  s.team = octet(team);
  s.nonce = nonce;
  s.tick = tick;
  for (int i = 0; i < max_robots_per_team; ++i) {
    s.left[i] = command.wheels[i].left;
    s.right[i] = command.wheels[i].right;
  }
  return s;
}

match::Command to_command(const mirocup_v1_TeamCommand& s) {
  match::Command command;
  for (int i = 0; i < max_robots_per_team; ++i) command.wheels[i] = {s.left[i], s.right[i]};
  return command;
}

}  // namespace mirocup::dds
