// SPDX-License-Identifier: MIT
//
// What the referee keeps an eye on because several laws ask for it: who stands in which area, who
// keeps goal, who is being pushed about.
#pragma once

#include "core/referee/laws/law.hpp"

namespace mirocup::referee {

struct Occupancy {
  // Robots with more than half of their body in an area, by whose end the area is and by team:
  // goal_area[index_of(end)][index_of(team)].
  ByEnd<ByEnd<RobotSet>> goal_area, penalty_area;

  ByRobot<double> at_home_s{};           // without a break in their own goal area
  ByEnd<std::optional<RobotId>> keeper;  // the robot that is longest in its own goal area
  ByRobot<double> excused_s{};           // for so long yet, because it is or was pushed
  ByEnd<RobotSet> shoved;                // those with time left
};

// Brings it up to the end of the tick.
void update_occupancy(const Pitch& pitch, const Situation& situation, Occupancy& occupancy);

// Robots of `team` in the area, without those that were pushed there.
inline RobotSet counted(const Occupancy& occupancy, const ByEnd<ByEnd<RobotSet>>& area, End owner,
                        End team) {
  return area[index_of(owner)][index_of(team)] & ~occupancy.shoved[index_of(team)];
}

}  // namespace mirocup::referee
