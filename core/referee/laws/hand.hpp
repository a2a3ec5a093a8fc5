// SPDX-License-Identifier: MIT
//
// A hand on the field. Source: MiroSot laws 8.8 and 11.3, a penalty kick: only the referee may
// touch a robot while play is on.
//
// Off unless `hand_penalty` is set. In a recorded trace the hand is a person's. In a match, a
// team's request for a placement out of its turn counts as a hand; only a program on the network
// can make one. The law has no memory.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_hand(const JudgedField& pitch, const TickFacts& situation);

}  // namespace mirocup::referee
