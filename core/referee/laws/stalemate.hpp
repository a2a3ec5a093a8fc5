// SPDX-License-Identifier: MIT
//
// Stalemate: the ball gets nowhere for `stalemate_s`. Sources: MiroSot laws 13 (a free ball)
// and 12.5 (a goal kick if the ball is in a goal area).
//
// "Nowhere" is a circle of `stalemate_radius_m` around the place where the count started: robots
// that shake the ball do not restart the count.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct StalemateMemory {
  std::optional<Vec2> anchor;  // where the ball was when the count started
  double still_s = 0.0;        // time since the count started
};

// True if `still_s` has reached the limit of the rules. `duration` is that of a tick, s.
bool is_stalemate(const JudgedField& pitch, const StalemateMemory& memory, double duration);

std::optional<Decision> judge_stalemate(const JudgedField& pitch, const TickFacts& situation,
                                        StalemateMemory& memory);

}  // namespace mirocup::referee
