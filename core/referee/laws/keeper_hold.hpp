// SPDX-License-Identifier: MIT
//
// The keeper must kick out. Source: MiroSot laws 8.6 and 11.2, within 10 s; a penalty kick.
//
// Judged as: the ball stays in the goal area for `keeper_hold_s` and no opponent contests it.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct KeeperHoldMemory {
  ByEnd<Dwell> held;  // how long the ball has been uncontested in that end's goal area
};

std::optional<Decision> judge_keeper_hold(const JudgedField& pitch, const TickFacts& situation,
                                          KeeperHoldMemory& memory);

}  // namespace mirocup::referee
