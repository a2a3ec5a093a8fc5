// SPDX-License-Identifier: MIT
#include "core/referee/laws/four_defenders.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_four_defenders(const Pitch& pitch, const Situation& s,
                                             const Watch& watch, FourDefendersMemory& memory) {
  const Rules& rules = pitch.rules;
  if (!pitch.field.penalty_area || rules.pa_def_max <= 0) return std::nullopt;
  std::optional<Decision> called;
  for (const End end : ends_from_ball(s)) {
    Dwell& crowded = memory.crowded[index_of(end)];
    const RobotSet defenders = counted(watch, watch.penalty_area, end, end);
    const int count = static_cast<int>(defenders.count());
    crowded.see(count > rules.pa_def_max, s.duration);
    if (called || !crowded.reached(rules.def_dwell_s, s.duration)) continue;
    if (!ball_in_zone(pitch, s, end)) continue;

    called = decide(Verdict::PENALTY_KICK, Law::four_defenders, s,
                    std::to_string(count) + " defenders in their penalty area for " +
                        fixed(crowded.for_s, 2) + " s, the ball in it");
    called->robots[index_of(end)] = defenders;
    called = against(*std::move(called), end, Restart::PENALTY_KICK);
  }
  return called;
}

}  // namespace mirocup::referee
