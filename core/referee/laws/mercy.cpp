// SPDX-License-Identifier: MIT
#include "core/referee/laws/mercy.hpp"

#include <cstdlib>

namespace mirocup::referee {

std::optional<Decision> judge_mercy(const JudgedField& pitch, const ByEnd<int>& score,
                                    const Decision& goal) {
  const int limit = pitch.rules.mercy_goal_diff;
  const int lead = std::abs(score[0] - score[1]);
  if (limit <= 0 || lead < limit) return std::nullopt;
  Decision d;
  d.verdict = Verdict::MATCH_END;
  d.law = Law::mercy;
  d.clock = goal.clock;
  d.ball = goal.ball;
  d.team = score[0] > score[1] ? End::left : End::right;
  d.reason = "a lead of " + std::to_string(lead) + " goals ends the match";
  return d;
}

}  // namespace mirocup::referee
