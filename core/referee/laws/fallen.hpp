// SPDX-License-Identifier: MIT
//
// Fallen robots. Source: MiroSot law 9: play stops, the robot is set upright, and play continues
// from the same positions.
//
// Applies to a robot that lies on its side and blocks a goal: a ball on the goal line, at the point
// nearest to the robot, would touch it. Simulated robots are squares in a plane and cannot fall, so
// only a recorded trace of a real pitch can show this. The law has no memory.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_fallen(const JudgedField& pitch, const TickFacts& situation);

}  // namespace mirocup::referee
