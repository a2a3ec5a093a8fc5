// SPDX-License-Identifier: MIT
#include "core/referee/laws/keeper_hold.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_keeper_hold(const Pitch& pitch, const Situation& s,
                                          KeeperHoldMemory& memory) {
  const field::Field& field = pitch.field;
  for (const End end : both_ends) {
    double& held = memory.held_s[index_of(end)];
    const bool holds = field.inside(field.goal_area, end, s.ball) && !is_contested(pitch, s, end);
    held = holds ? held + s.duration : 0.0;
    if (held < pitch.rules.keeper_hold_s) continue;

    Decision d = decide(Verdict::PENALTY_KICK, Law::keeper_hold, s,
                        "the ball was in the " + std::string(to_string(end)) +
                            " goal area, uncontested, for " + fixed(held, 1) + " s");
    d.team = end;
    d.restart = Restart::PENALTY_KICK;
    d.taker = opposite(end);
    return d;
  }
  return std::nullopt;
}

}  // namespace mirocup::referee
