// SPDX-License-Identifier: MIT
//
// A large lead ends the match. Source: practice of leagues; the MiroSot texts do not state it. Off
// if `mercy_goal_diff` is 0.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

// Called after a goal, with the score that includes it. The end of the match follows the goal in
// the same tick. The law has no memory.
std::optional<Decision> judge_mercy(const JudgedField& pitch, const ByEnd<int>& score,
                                    const Decision& goal);

}  // namespace mirocup::referee
