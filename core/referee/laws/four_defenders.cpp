// SPDX-License-Identifier: MIT
#include "core/referee/laws/four_defenders.hpp"

#include <utility>

namespace mirocup::referee {

std::optional<Decision> judge_four_defenders(const Pitch& pitch, const Situation& s,
                                             const Occupancy& occupancy,
                                             FourDefendersMemory& memory) {
  const Rules& rules = pitch.rules;
  const CrowdLimit limit{.area = occupancy.penalty_area,
                         .side = Side::defenders,
                         .most = rules.pa_def_max,
                         .patience = rules.def_dwell_s,
                         .patience_beyond = rules.def_dwell_s};
  const auto crowd = find_crowd(pitch, s, occupancy, limit, std::nullopt, memory.crowded);
  if (!crowd) return std::nullopt;

  const End team = crowd->owner;
  Decision d =
      decide(Verdict::PENALTY_KICK, Law::four_defenders, s,
             std::to_string(crowd->robots.count()) + " defenders in their penalty area for " +
                 fixed(crowd->for_s, 2) + " s, the ball in it");
  d.robots[index_of(team)] = crowd->robots;
  return against(std::move(d), team, Restart::PENALTY_KICK);
}

}  // namespace mirocup::referee
