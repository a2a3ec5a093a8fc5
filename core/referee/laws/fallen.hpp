// SPDX-License-Identifier: MIT
//
// A robot that fell over and blocks the goal. Source: MiroSot law 9: play is stopped, the robot is
// set upright, and play goes on from the same positions. Only a film can show it: simulated robots
// are squares in a plane. It blocks the goal if a ball on the goal line would touch it where it is
// nearest.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_fallen(const Pitch& pitch, const Situation& situation);

}  // namespace mirocup::referee
