// SPDX-License-Identifier: MIT
#include "core/match/observation.hpp"

namespace mirocup::match {

namespace {

ObservedRobot observed(End end, const simulator::BodyState& robot) {
  const Vec2 velocity = robot.heading.to_world({robot.twist.forward, robot.twist.left});
  return {.position = team_frame(end, robot.position),
          .heading = team_frame(end, robot.heading).angle(),
          .velocity = team_frame(end, velocity),
          .turn = robot.twist.omega};
}

}  // namespace

Observation observe(const Snapshot& scene, Team team, int robots) {
  const Team other = opponent_of(team);
  const End end = scene.left == team ? End::left : End::right;
  Observation o;
  o.tick = scene.tick;
  o.time = scene.time;
  o.clock = scene.clock;
  o.state = scene.state;
  o.phase = scene.phase;
  o.restart = scene.restart;
  o.own_restart = scene.taker == team;
  o.placing = scene.placing == team;
  o.own_score = scene.score[index_of(team)];
  o.opponent_score = scene.score[index_of(other)];
  o.robots = robots;
  o.stalemate_s = scene.stalemate_s;
  o.advantage_s = scene.advantage_s;
  o.own_counts = scene.counts[index_of(team)];
  o.opponent_counts = scene.counts[index_of(other)];
  o.ball = team_frame(end, scene.ball.position);
  o.ball_velocity = team_frame(end, scene.ball.velocity);
  for (int i = 0; i < robots; ++i) {
    o.own[i] = observed(end, scene.robots[index_of(team)][i]);
    o.opponent[i] = observed(end, scene.robots[index_of(other)][i]);
  }
  return o;
}

}  // namespace mirocup::match
