// SPDX-License-Identifier: MIT
//
// What teams may ask for at a restart, and what becomes of a pose that they may not have.
//
// Both teams may say where they want to stand. A robot keeps its pose if it is inside the walls,
// where the law of the restart allows it, and clear of the ball and of everybody who was accepted
// before it; the team that places first goes first. Only the others are moved: to the default pose
// of their role if that is free, else to the first free default pose of their team, else to the
// first free place that the law allows.
#pragma once

#include "core/referee/laws/law.hpp"
#include "core/referee/placement.hpp"

namespace mirocup::referee {

// Who says first where its robots stand.
End first_placer(Restart restart, End taker);

struct CheckedPlacement {
  Placement placement;
  ByEnd<RobotSet> moved;
  bool ball_moved = false;

  bool any_moved() const { return ball_moved || moved[0].any() || moved[1].any(); }
};

// `taker` and `spot` as in the decision that gave the restart.
CheckedPlacement check_placement(const Pitch& pitch, Restart restart, End taker, const Vec2& spot,
                                 const Placement& asked);

}  // namespace mirocup::referee
