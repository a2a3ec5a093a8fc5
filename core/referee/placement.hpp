// SPDX-License-Identifier: MIT
//
// Where everything stands at a restart. Robot 0 of a team is its keeper, robot 1 its kicker or
// contender; the others follow in the order of the tables. The poses are legal for every restart
// and overlap nothing (tests/unit/core/referee/placement_test.cpp).
//
// Sources: the figures of the FIRA rule texts where they give poses (penalty, free ball); else
// common practice.
#pragma once

#include "core/referee/decision.hpp"
#include "core/referee/pitch.hpp"

#include <array>

namespace mirocup::referee {

// Roles at restarts, by index.
inline constexpr int keeper = 0;
inline constexpr int kicker = 1;

struct Placement {
  Vec2 ball{0.0, 0.0};
  ByEnd<std::array<Pose, max_robots_per_team>> robots;
};

// The default poses of a restart. `spot` says which quarter a free ball is played in; the others
// have one spot.
Placement default_placement(const Pitch& pitch, Restart restart, End taker, const Vec2& spot);

}  // namespace mirocup::referee
