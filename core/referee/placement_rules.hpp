// SPDX-License-Identifier: MIT
//
// Where a robot may stand at a restart, by the law of that restart. Sources: MiroSot laws 6.2, 10,
// 11, 12 and 13 and their figures.
#pragma once

#include "core/referee/placement.hpp"

namespace mirocup::referee {

// The robots that may stand in a special place.
enum class Roles {
  any,    // whoever is sent there
  fixed,  // in a shoot-out, where only two robots move: robot 1 as kicker, robot 0 as keeper
};

// The restart that is placed. Positions in it are in the field's frame.
struct PlacementRules {
  const Pitch& pitch;
  Restart restart = Restart::none;
  End taker = End::left;
  Roles roles = Roles::any;
  const Placement& defaults;
  Vec2 ball{0.0, 0.0};
};

// Inside the walls, with its whole body?
bool is_inside_walls(const Pitch& pitch, const Pose& robot);

// May any robot of that team stand so?
bool may_stand(const PlacementRules& standing, End team, const Pose& robot);

// Does the robot stand where one robot of its team may, or must, stand alone: the kicker behind the
// ball, the keeper on its line (in a shoot-out anywhere in its goal area), a contender at its
// place?
bool has_special_place(const PlacementRules& standing, End team, const Pose& robot);

// The robot that takes the special place if nobody stands there of its own will; -1: nobody has to.
int holder_of_special_place(const PlacementRules& standing, End team);

}  // namespace mirocup::referee
