// SPDX-License-Identifier: MIT
#include "core/match/start.hpp"

namespace mirocup::match {

namespace {

// A restart has the name of its verdict, but for none.
referee::Verdict verdict_of(referee::Restart restart) {
  return from_string<referee::Verdict>(to_string(restart)).value_or(referee::Verdict::NONE);
}

End end_of(const Start& start, Team team) {
  return team == start.left ? End::left : End::right;
}

}  // namespace

referee::Decision restart_of(const Start& start) {
  referee::Decision decision;
  decision.clock = start.clock;
  decision.law = referee::Law::placement;
  decision.taker = end_of(start, Team::blue);
  if (start.ball) decision.ball = start.ball->position;
  if (!start.restart) return decision;
  const RestartStart& restart = *start.restart;
  decision.verdict = verdict_of(restart.kind);
  decision.restart = restart.kind;
  decision.taker = end_of(start, restart.taker);
  decision.spot = {restart.quarter.x, restart.quarter.y};
  decision.reason = "the leg starts with it";
  return decision;
}

referee::Placement placement_of(const referee::JudgedField& pitch, const Start& start) {
  const referee::Decision restart = restart_of(start);
  referee::Placement placement =
      referee::default_placement(pitch, restart.restart, restart.taker, restart.spot);
  if (start.ball) placement.ball = start.ball->position;
  for (const Team team : both_teams) {
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      const auto& given = start.robots[index_of(team)][i].state;
      if (given) placement.robots[index_of(end_of(start, team))][i] = *given;
    }
  }
  return placement;
}

}  // namespace mirocup::match
