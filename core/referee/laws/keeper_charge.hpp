// SPDX-License-Identifier: MIT
//
// Charging the goalkeeper. Source: MiroSot laws 8.2 and 12.1, a goal kick.
//
// A brush is part of play. A charge is a contact in which the attacker drives at the keeper for
// `charge_s`, or a first impact at `charge_speed_mps` or more. If the ball lies between the two and
// touches one of them, the charge is allowed.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

struct KeeperChargeMemory {
  // How long each attacker has driven at the keeper.
  ByEnd<std::array<Dwell, max_robots_per_team>> driven;
  ByRobot<bool> touched{};  // by attacker: it touched the keeper in the last tick
};

std::optional<Decision> judge_keeper_charge(const JudgedField& pitch, const TickFacts& situation,
                                            const Occupancy& occupancy, KeeperChargeMemory& memory);

}  // namespace mirocup::referee
