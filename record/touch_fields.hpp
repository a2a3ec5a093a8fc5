// SPDX-License-Identifier: MIT
//
// The JSON of a robot that touched the ball, in records and statistics.
#pragma once

#include "core/match/goal_credit.hpp"
#include "record/json_fields.hpp"

namespace mirocup::record {

void list_fields(auto& f, match::Touch& touch) {
  f("team", touch.team);
  f("robot", touch.robot, 0, max_robots_per_team - 1);
}

}  // namespace mirocup::record
