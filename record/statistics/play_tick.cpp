// SPDX-License-Identifier: MIT
#include "record/statistics/play_tick.hpp"

namespace mirocup::statistics {

LegWatcher::LegWatcher(const match::Leg& leg) : before_(leg.snapshot()) {}

PlayTick LegWatcher::see(const match::Leg& leg) {
  const match::Snapshot now = leg.snapshot();
  PlayTick tick;
  tick.tick = before_.tick;
  tick.is_play = leg.judged().has_value();
  tick.goes_on = now.state == match::State::PLAY;
  tick.phase = before_.phase;
  tick.left = before_.left;
  tick.ball_velocity = now.ball.velocity;
  tick.decisions = std::span(leg.decisions()).subspan(decisions_);
  decisions_ = leg.decisions().size();
  if (tick.is_play) {
    // The situation shows where the bodies were before a restart moved them.
    const referee::Situation& judged = *leg.judged();
    tick.ball = judged.ball;
    for (const Team team : both_teams) {
      const int end = index_of(team == before_.left ? End::left : End::right);
      tick.touched[index_of(team)] = judged.touched_ball[end];
      for (int i = 0; i < leg.field().robots_per_team; ++i) {
        tick.driven[index_of(team)] +=
            (judged.robots[end][i].position - before_.robots[index_of(team)][i].position).norm();
      }
    }
  }
  before_ = now;
  return tick;
}

}  // namespace mirocup::statistics
