// SPDX-License-Identifier: MIT
#include "core/referee/laws/two_defenders.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_two_defenders(const Pitch& pitch, const Situation& s,
                                            const Watch& watch, TwoDefendersMemory& memory) {
  const Rules& rules = pitch.rules;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    Dwell& crowded = memory.crowded[index_of(end)];
    const RobotSet defenders = counted(watch, watch.goal_area, end, end);
    const int count = static_cast<int>(defenders.count());
    crowded.see(rules.def_max > 0 && count > rules.def_max, s.duration);
    if (called || !crowded.reached(rules.def_dwell_s, s.duration)) continue;
    if (!ball_in_zone(pitch, s, end)) continue;

    called = decide(Verdict::PENALTY_KICK, Law::two_defenders, s,
                    std::to_string(count) + " defenders in their goal area for " +
                        fixed(crowded.for_s, 2) + " s, the ball at x = " + fixed(s.ball.x(), 3) +
                        " m, y = " + fixed(s.ball.y(), 3) + " m");
    called->robots[index_of(end)] = defenders;
    called = against(*std::move(called), end, Restart::PENALTY_KICK);
  }
  return called;
}

}  // namespace mirocup::referee
