// SPDX-License-Identifier: MIT
//
// What teams may ask for at a restart, and what becomes of a pose that they may not have.
//
// Both teams may say where they want to stand, one after the other in a match, both at once in a
// recorded situation. A robot keeps its pose if it is inside the walls,
// where the law of the restart allows it, and clear of the ball and of everybody who was accepted
// before it; the team that places first goes first. Only the others are moved: to the default pose
// of their role if that is free, else to the first free default pose of their team, else to the
// first free place that the law allows.
#pragma once

#include "core/referee/placement_rules.hpp"

namespace mirocup::referee {

// Who says first where its robots stand.
End first_placer(Restart restart, End taker);

// Why a robot may not stand where it was asked for.
enum class Misplaced {
  no,
  outside_walls,        // or nowhere: a pose that is not finite
  not_allowed,          // by the law of the restart
  special_place_empty,  // somebody has to stand in the special place, and this robot is the one
  second_in_goal_area,  // of the opponents, at a goal kick
  too_near_ball,
  too_near_robot,
};

struct CheckedPlacement {
  Placement placement;
  ByEnd<RobotSet> moved;
  ByRobot<Misplaced> why{};
  bool ball_moved = false;

  bool any_moved() const { return ball_moved || moved[0].any() || moved[1].any(); }
};

// What both teams ask for at once.
CheckedPlacement check_placement(const Pitch& pitch, const Decision& restart, Roles roles,
                                 const Placement& asked);

// What one team asks for when it is its turn: `asked` has its poses, and the others as they stand.
// The robots of the team that places second make way if they have to; those of the first stay.
// Only the taker who places first has a choice of the ball's place.
CheckedPlacement check_turn(const Pitch& pitch, const Decision& restart, End team, Roles roles,
                            const Placement& asked);

// A sentence: who was moved from where to where, and why. `asked` as it was checked.
std::string reason_of(const Pitch& pitch, const Placement& asked, const CheckedPlacement& checked);

}  // namespace mirocup::referee
