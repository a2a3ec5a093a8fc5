// SPDX-License-Identifier: MIT
#include "core/referee/laws/two_attackers.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_two_attackers(const Pitch& pitch, const Situation& s,
                                            const Watch& watch, std::optional<End> goal_at,
                                            TwoAttackersMemory& memory) {
  const Rules& rules = pitch.rules;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    Dwell& crowded = memory.crowded[index_of(end)];
    const End team = opposite(end);
    const RobotSet attackers = counted(watch, watch.goal_area, end, team);
    const int count = static_cast<int>(attackers.count());
    crowded.see(rules.att_max > 0 && count > rules.att_max, s.duration);
    const double patience = count > rules.att_max + 1 ? 0.0 : rules.att_dwell_s;
    if (called || !crowded.reached(patience, s.duration)) continue;
    if (!ball_in_zone(pitch, s, end) && goal_at != end) continue;

    called = decide(Verdict::GOAL_KICK, Law::two_attackers, s,
                    std::to_string(count) + " attackers in the goal area for " +
                        fixed(crowded.for_s, 2) + " s, the ball at x = " + fixed(s.ball.x(), 3) +
                        " m, y = " + fixed(s.ball.y(), 3) + " m");
    called->robots[index_of(team)] = attackers;
    called = against(*std::move(called), team, Restart::GOAL_KICK);
  }
  return called;
}

}  // namespace mirocup::referee
