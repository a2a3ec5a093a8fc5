// SPDX-License-Identifier: MIT
//
// A goal. Source: MiroSot law 7.1, "the whole of the ball passes over the goal line": its centre
// crosses the line that lies one ball radius behind the goal line, between the posts.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

// Remembers nothing. The decision's clock is the moment of the crossing, interpolated within the
// tick.
std::optional<Decision> judge_goal(const Pitch& pitch, const Situation& situation);

}  // namespace mirocup::referee
