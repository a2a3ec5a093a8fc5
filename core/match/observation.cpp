// SPDX-License-Identifier: MIT
#include "core/match/observation.hpp"

#include "core/base/assert.hpp"

namespace mirocup::match {

Observation observe(const Snapshot& scene, Team team, int robots) {
  MIROCUP_ASSERT(0 <= robots && robots <= max_robots_per_team);
  const Team other = opponent_of(team);
  const End end = scene.left == team ? End::left : End::right;
  Observation o{.tick = scene.tick,
                .time = scene.time,
                .clock = scene.clock,
                .state = scene.state,
                .phase = scene.phase,
                .restart = scene.restart,
                .own_restart = scene.taker == team,
                .placing = scene.placing == team,
                .own_score = scene.score[index_of(team)],
                .opponent_score = scene.score[index_of(other)],
                .robots = robots,
                .stalemate_s = scene.stalemate_s,
                .advantage_s = scene.advantage_s,
                .own_counts = scene.counts[index_of(team)],
                .opponent_counts = scene.counts[index_of(other)],
                .ball = team_frame(end, scene.ball.position),
                .ball_velocity = team_frame(end, scene.ball.velocity),
                .ball_age = scene.ball_age,
                .own = {},
                .opponent = {}};
  for (int i = 0; i < robots; ++i) {
    o.own[i] = team_frame(end, scene.robots[index_of(team)][i]);
    o.opponent[i] = team_frame(end, scene.robots[index_of(other)][i]);
  }
  return o;
}

}  // namespace mirocup::match
