// SPDX-License-Identifier: MIT
//
// A hand on the field. Source: MiroSot laws 8.8 and 11.3, a penalty kick: only the referee may
// touch a robot while play is on.
//
// Off unless `hand_penalty` is set. In a recorded trace the hand is a person's. In a match it is a
// team that asks for a placement when it is not its turn, which only a program on the network can
// do. The law has no memory.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_hand(const Pitch& pitch, const Situation& situation);

}  // namespace mirocup::referee
