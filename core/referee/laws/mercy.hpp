// SPDX-License-Identifier: MIT
//
// A lead of ten ends the match. Source: league practice (the MiroSot texts do not state it); off
// where the parameter is 0.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

// Remembers nothing. Asked after a goal, which it follows in the same tick.
std::optional<Decision> judge_mercy(const Pitch& pitch, const ByEnd<int>& score,
                                    const Decision& goal);

}  // namespace mirocup::referee
