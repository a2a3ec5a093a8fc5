// SPDX-License-Identifier: MIT
//
// Blocking the goalkeeper. Source: MiroSot laws 8.7 and 12.3, a goal kick. Intent is standing in
// front of the keeper, which wants to pass, with no business with the ball.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct KeeperBlockMemory {
  ByEnd<std::array<Dwell, max_robots_per_team>> blocks;  // by attacker
};

std::optional<Decision> judge_keeper_block(const Pitch& pitch, const Situation& situation,
                                           const Occupancy& occupancy, KeeperBlockMemory& memory);

}  // namespace mirocup::referee
