// SPDX-License-Identifier: MIT
//
// The goalkeeper catches the ball with its appendages, which it may. Source: MiroSot law 12.4, a
// goal kick for its team. Measured like holding the ball.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct KeeperCatchMemory {
  ByEnd<Dwell> holds;
};

std::optional<Decision> judge_keeper_catch(const Pitch& pitch, const Situation& situation,
                                           const Occupancy& occupancy, KeeperCatchMemory& memory);

}  // namespace mirocup::referee
