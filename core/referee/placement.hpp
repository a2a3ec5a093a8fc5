// SPDX-License-Identifier: MIT
//
// Where everything stands at a restart by default.
//
// Robot 0 of a team is its keeper, robot 1 its kicker or contender; the others follow in the order
// of the tables in placement.cpp. The poses are legal for every restart and overlap nothing
// (tests/unit/core/referee/placement_test.cpp).
//
// Sources: for penalty and free ball, the figures of the FIRA rule texts, which give poses; for the
// other restarts, common practice.
#pragma once

#include "core/referee/decision.hpp"
#include "core/referee/judged_field.hpp"

#include <array>

namespace mirocup::referee {

// The roles at restarts, by index of the robot.
inline constexpr int keeper = 0;
inline constexpr int kicker = 1;

// Ball and robots in the field's frame. All are at rest.
struct Placement {
  Vec2 ball{0.0, 0.0};
  ByEnd<std::array<Pose, max_robots_per_team>> robots;
};

// Returns the default placement of a restart. `spot` chooses the quarter of a free ball; the other
// restarts have one spot and ignore it.
Placement default_placement(const JudgedField& pitch, Restart restart, End taker, const Vec2& spot);

}  // namespace mirocup::referee
