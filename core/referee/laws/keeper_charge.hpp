// SPDX-License-Identifier: MIT
//
// Charging the goalkeeper. Source: MiroSot laws 8.2 and 12.1, a goal kick; allowed through the
// ball. A brush is part of play: it takes a driven contact of some length, or a hard first impact.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct KeeperChargeMemory {
  ByEnd<std::array<Dwell, max_robots_per_team>> driven;  // by attacker
  ByRobot<bool> touched{};  // the keeper, in the last tick, by attacker
};

std::optional<Decision> judge_keeper_charge(const Pitch& pitch, const Situation& situation,
                                            const Occupancy& occupancy, KeeperChargeMemory& memory);

}  // namespace mirocup::referee
