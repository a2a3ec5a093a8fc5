// SPDX-License-Identifier: MIT
#include "core/referee/laws/four_attackers.hpp"

#include <utility>

namespace mirocup::referee {

std::optional<Decision> judge_four_attackers(const Pitch& pitch, const Situation& s,
                                             const Occupancy& occupancy, std::optional<End> goal_at,
                                             FourAttackersMemory& memory) {
  const Rules& rules = pitch.rules;
  const CrowdLimit limit{.area = occupancy.penalty_area,
                         .side = Side::attackers,
                         .most = rules.pa_att_max,
                         .patience = rules.att_dwell_s,
                         .patience_beyond = rules.att_dwell_s};
  const auto crowd = find_crowd(pitch, s, occupancy, limit, goal_at, memory.crowded);
  if (!crowd) return std::nullopt;

  const End team = opposite(crowd->owner);
  Decision d =
      decide(Verdict::GOAL_KICK, Law::four_attackers, s,
             std::to_string(crowd->robots.count()) + " attackers in the penalty area for " +
                 fixed(crowd->for_s, 2) + " s, the ball in it");
  d.robots[index_of(team)] = crowd->robots;
  return against(std::move(d), team, Restart::GOAL_KICK);
}

}  // namespace mirocup::referee
