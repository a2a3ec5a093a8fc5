// SPDX-License-Identifier: MIT
//
// The keeper's catch. Source: MiroSot law 12.4, a goal kick for the keeper's team: a keeper may
// catch the ball with its appendages.
//
// Measured like holding the ball (holding.hpp), with the ball in the keeper's goal area.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct KeeperCatchMemory {
  ByEnd<Dwell> holds;  // how long each end's keeper has held the ball
};

std::optional<Decision> judge_keeper_catch(const JudgedField& pitch, const TickFacts& situation,
                                           const Occupancy& occupancy, KeeperCatchMemory& memory);

}  // namespace mirocup::referee
