// SPDX-License-Identifier: MIT
#include "core/referee/laws/four_attackers.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_four_attackers(const Pitch& pitch, const Situation& s,
                                             const Watch& watch, std::optional<End> goal_at,
                                             FourAttackersMemory& memory) {
  const Rules& rules = pitch.rules;
  if (!pitch.field.penalty_area || rules.pa_att_max <= 0) return std::nullopt;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    Dwell& crowded = memory.crowded[index_of(end)];
    const End team = opposite(end);
    const RobotSet attackers = counted(watch, watch.penalty_area, end, team);
    const int count = static_cast<int>(attackers.count());
    crowded.see(count > rules.pa_att_max, s.duration);
    if (called || !crowded.reached(rules.att_dwell_s, s.duration)) continue;
    if (!ball_in_zone(pitch, s, end) && goal_at != end) continue;

    called = decide(Verdict::GOAL_KICK, Law::four_attackers, s,
                    std::to_string(count) + " attackers in the penalty area for " +
                        fixed(crowded.for_s, 2) + " s, the ball in it");
    called->robots[index_of(team)] = attackers;
    called = against(*std::move(called), team, Restart::GOAL_KICK);
  }
  return called;
}

}  // namespace mirocup::referee
