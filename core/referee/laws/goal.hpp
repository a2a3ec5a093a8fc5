// SPDX-License-Identifier: MIT
//
// Goals. Source: MiroSot law 7.1, "the whole of the ball passes over the goal line": the centre of
// the ball crosses, between the posts, the line that is one ball radius behind the goal line.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

// Returns a goal for the end at which the ball crosses in this tick. The decision's clock is the
// moment of the crossing, interpolated within the tick. A ball that ends the tick behind that line
// and between the posts is also a goal, wherever its straight path crosses that line. The law has
// no memory.
std::optional<Decision> judge_goal(const JudgedField& pitch, const TickFacts& situation);

}  // namespace mirocup::referee
