// SPDX-License-Identifier: MIT
//
// Putting robots and ball down by hand at a restart: a hand never hits the exact place.
#pragma once

#include "core/match/disturbances.hpp"
#include "core/referee/placement_check.hpp"

namespace mirocup::match {

// The bodies that a hand puts down. The others stay where they are.
struct Moved {
  referee::ByEnd<referee::RobotSet> robots;
  bool ball = false;

  // Returns the bodies that differ between two placements of `robots_per_team` robots.
  static Moved between(const referee::Placement& from, const referee::Placement& to,
                       int robots_per_team);
  static Moved everything(int robots_per_team);
};

// Returns where the bodies come to stand. `wanted` must be legal. Each body in `moved` comes to
// stand off its wanted place by an error that is drawn for it. If the law of the restart does not
// allow that place, the error is halved until the law does. `left` is the team at the left end.
referee::Placement put_down(const referee::JudgedField& pitch, const referee::Decision& restart,
                            referee::Roles roles, const referee::Placement& wanted,
                            const Moved& moved, Team left, Disturbances& disturbances);

}  // namespace mirocup::match
