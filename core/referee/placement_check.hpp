// SPDX-License-Identifier: MIT
//
// The check of the placement that a team asks for at a restart.
//
// Both teams may ask for places: one after the other in a match, both at once in a recorded
// situation. A robot may have the pose that was asked for if it is inside the walls, if the law of
// the restart allows it, and if it is clear of the ball and of all other robots; the team that
// places first has precedence. As few robots of a team as possible are moved, to the nearest places
// that are free (placer.hpp).
#pragma once

#include "core/referee/placer.hpp"

namespace mirocup::referee {

// Returns the end whose team places first.
End first_placer(Restart restart, End taker);

// The placement that is granted.
struct CheckedPlacement {
  Placement placement;
  ByEnd<RobotSet> moved;  // the robots that did not get the requested pose
  ByRobot<Misplaced> why{};
  bool ball_moved = false;

  bool any_moved() const { return ball_moved || moved[0].any() || moved[1].any(); }
};

// Checks the requests of both teams together.
CheckedPlacement check_placement(const JudgedField& pitch, const Decision& restart, Roles roles,
                                 const Placement& asked);

// Checks what one team asks for in its turn. `asked` is a whole placement: the team's robots where
// it wants them, all others where they stand, and the ball on its spot or where the team wants it.
// In the first team's turn robots of the second team are moved if they stand on a granted place; in
// the second team's turn the first team's robots stay. The ball may be moved only in the turn of
// a taker that places first.
CheckedPlacement check_turn(const JudgedField& pitch, const Decision& restart, End team,
                            Roles roles, const Placement& asked);

// Returns the fewest robots that would have to be moved so that all stand where they may, with the
// ball where it lies. So of two robots that are too near to each other only one is named.
ByEnd<RobotSet> misplaced_robots(const JudgedField& pitch, const Decision& restart, Roles roles,
                                 const Placement& standing);

// Returns true if the ball may be put at `ball`, m. The place must be clear of the walls and, at a
// kick-off and a goal kick, one that the taker may choose. At other restarts the caller passes a
// place near the spot.
bool may_put_ball(const JudgedField& pitch, const Decision& restart, const Vec2& ball);

// Returns a sentence that says which bodies were moved, from where to where, and why. `asked` is
// the placement that was checked.
std::string reason_of(const JudgedField& pitch, const Placement& asked,
                      const CheckedPlacement& checked);

}  // namespace mirocup::referee
