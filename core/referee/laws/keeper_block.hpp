// SPDX-License-Identifier: MIT
//
// Blocking the goalkeeper. Source: MiroSot laws 8.7 and 12.3, a goal kick.
//
// Intent is judged by what can be measured: for `block_s` an attacker is within `block_gap_m` of a
// keeper that drives at it, while the ball is in the keeper's half and farther than `block_ball_m`
// from both. An attacker that a team-mate of the keeper pushes, and that does not push back, does
// not offend.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct KeeperBlockMemory {
  ByEnd<std::array<Dwell, max_robots_per_team>> blocks;  // how long each attacker has blocked
};

std::optional<Decision> judge_keeper_block(const JudgedField& pitch, const TickFacts& situation,
                                           const Occupancy& occupancy, KeeperBlockMemory& memory);

}  // namespace mirocup::referee
