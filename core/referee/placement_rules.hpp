// SPDX-License-Identifier: MIT
//
// The places where a robot may stand at a restart, by the law of that restart.
//
// Sources: MiroSot laws 6.2, 10, 11, 12 and 13 and their figures.
#pragma once

#include "core/referee/placement.hpp"

namespace mirocup::referee {

// Which robot of a team may stand in the team's special place (has_special_place()).
enum class Roles {
  any,    // any robot, but one only
  fixed,  // in a shoot-out, where only two robots move: robot 1 as kicker, robot 0 as keeper
};

// The facts on which the rules of a placement depend. Positions are in the field's frame, in
// metres. Pitch and defaults belong to the caller and outlive this object.
struct PlacementRules {
  const JudgedField& pitch;
  Restart restart = Restart::none;
  End taker = End::left;
  Roles roles = Roles::any;
  const Placement& defaults;
  Vec2 ball{0.0, 0.0};
};

// True if the pose is finite and the robot's whole body is inside the walls.
bool is_inside_walls(const JudgedField& pitch, const Pose& robot);

// True if the law allows this pose to every robot of the team, whatever its role.
bool may_stand(const PlacementRules& rules, End team, const Pose& robot);

// True if the robot stands in the special place of its team, where one robot alone may or must
// stand: the kicker behind the ball, the keeper on its line (in a shoot-out anywhere in its goal
// area), a contender at its mark.
bool has_special_place(const PlacementRules& rules, End team, const Pose& robot);

// Returns the robot that the referee puts into the special place when the team leaves it empty; -1
// if the place may stay empty.
int holder_of_special_place(const PlacementRules& rules, End team);

}  // namespace mirocup::referee
