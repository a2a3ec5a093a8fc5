// SPDX-License-Identifier: MIT
#include "core/referee/laws/two_attackers.hpp"

#include <utility>

namespace mirocup::referee {

std::optional<Decision> judge_two_attackers(const Pitch& pitch, const Situation& s,
                                            const Occupancy& occupancy, std::optional<End> goal_at,
                                            TwoAttackersMemory& memory) {
  const Rules& rules = pitch.rules;
  const CrowdLimit limit{.area = occupancy.goal_area,
                         .side = Side::attackers,
                         .most = rules.att_max,
                         .patience = rules.att_dwell_s,
                         .patience_beyond = 0.0};
  const auto crowd = find_crowd(pitch, s, occupancy, limit, goal_at, memory.crowded);
  if (!crowd) return std::nullopt;

  const End team = opposite(crowd->owner);
  Decision d = decide(Verdict::GOAL_KICK, Law::two_attackers, s,
                      std::to_string(crowd->robots.count()) + " attackers in the goal area for " +
                          fixed(crowd->for_s, 2) + " s, the ball at x = " + fixed(s.ball.x(), 3) +
                          " m, y = " + fixed(s.ball.y(), 3) + " m");
  d.robots[index_of(team)] = crowd->robots;
  return against(std::move(d), team, Restart::GOAL_KICK);
}

}  // namespace mirocup::referee
