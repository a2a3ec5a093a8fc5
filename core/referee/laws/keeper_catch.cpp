// SPDX-License-Identifier: MIT
#include "core/referee/laws/keeper_catch.hpp"

#include "core/referee/laws/holding.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_keeper_catch(const JudgedField& pitch, const TickFacts& s,
                                           const Occupancy& occupancy, KeeperCatchMemory& memory) {
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    const std::optional<RobotId>& keeper = occupancy.keeper[index_of(end)];
    Dwell& holds = memory.holds[index_of(end)];
    holds.sample(keeper && pitch.field.inside(pitch.field.goal_area, end, s.ball) &&
                     hides_ball(pitch, s, *keeper),
                 s.duration);
    if (called || !holds.reached(pitch.rules.hide_s, s.duration)) continue;
    called = decide(Verdict::GOAL_KICK, Law::keeper_catch, s,
                    "the keeper held the ball for " + fixed(holds.for_s, 2) + " s");
    called->add_robot(*keeper);
    called->team = end;
    called->restart = Restart::GOAL_KICK;
    called->taker = end;
  }
  return called;
}

}  // namespace mirocup::referee
