// SPDX-License-Identifier: MIT
#include "core/referee/laws/hand.hpp"

#include <utility>

namespace mirocup::referee {

std::optional<Decision> judge_hand(const JudgedField& pitch, const TickFacts& s) {
  if (!pitch.rules.hand_penalty) return std::nullopt;
  for (const End end : ends_from_ball(s)) {
    if (!s.hand[index_of(end)]) continue;
    Decision d = decide(Verdict::PENALTY_KICK, Law::hand, s,
                        "the " + std::string(to_string(end)) + " team reached onto the field");
    return against(std::move(d), end, Restart::PENALTY_KICK);
  }
  return std::nullopt;
}

}  // namespace mirocup::referee
