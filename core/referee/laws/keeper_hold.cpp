// SPDX-License-Identifier: MIT
#include "core/referee/laws/keeper_hold.hpp"

#include <utility>

namespace mirocup::referee {

std::optional<Decision> judge_keeper_hold(const JudgedField& pitch, const TickFacts& s,
                                          KeeperHoldMemory& memory) {
  const field::Field& field = pitch.field;
  for (const End end : both_ends) {
    Dwell& held = memory.held[index_of(end)];
    held.sample(field.inside(field.goal_area, end, s.ball) && !is_contested(pitch, s, end),
                s.duration);
    if (!held.reached(pitch.rules.keeper_hold_s, s.duration)) continue;

    Decision d = decide(Verdict::PENALTY_KICK, Law::keeper_hold, s,
                        "the ball was in the " + std::string(to_string(end)) +
                            " goal area, uncontested, for " + fixed(held.for_s, 1) + " s");
    return against(std::move(d), end, Restart::PENALTY_KICK);
  }
  return std::nullopt;
}

}  // namespace mirocup::referee
