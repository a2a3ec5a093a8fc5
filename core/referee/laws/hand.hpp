// SPDX-License-Identifier: MIT
//
// A hand on the field. Source: MiroSot laws 8.8 and 11.3, a penalty kick: nobody but the referee
// touches a robot while play is on. Off unless the parameter is set. In a film it is a person; in a
// match it is a team that says where its robots are to stand when nobody has asked it, which only a
// program on the network can do.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

std::optional<Decision> judge_hand(const Pitch& pitch, const Situation& situation);

}  // namespace mirocup::referee
