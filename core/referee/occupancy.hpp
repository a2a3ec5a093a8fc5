// SPDX-License-Identifier: MIT
//
// The occupancy tracker for several laws: which robots stand in which area, which robot keeps goal,
// and which robots are pushed about by opponents.
#pragma once

#include "core/referee/judged_field.hpp"
#include "core/referee/tick_facts.hpp"

#include <optional>

namespace mirocup::referee {

struct Occupancy {
  // The robots that have more than half of their body in an area, by the end that owns the area and
  // by team: goal_area[index_of(owner)][index_of(team)].
  ByEnd<ByEnd<RobotSet>> goal_area, penalty_area;

  // The time for which each robot has been in its own goal area without a break, s.
  ByRobot<double> at_home_s{};
  // The keeper of each end: the robot that has been in its own goal area for the longest time; of
  // several, the robot of the lowest index. Nothing if no robot of the team is there.
  ByEnd<std::optional<RobotId>> keeper;

  // The time for which each robot is still excused for standing in an area, s. It is `shoved_s` of
  // the rules while an opponent that touches the robot drives at it and the robot does not drive
  // back; afterwards it runs down to 0.
  ByRobot<double> excused_s{};
  ByEnd<RobotSet> shoved;  // the robots that are still excused
};

// Brings the occupancy up to the end of the situation's tick. Called once a tick, before the laws.
void update_occupancy(const JudgedField& pitch, const TickFacts& situation, Occupancy& occupancy);

// Returns the robots of `team` in the owner's area, without those that were pushed there. `area` is
// the occupancy's goal_area or penalty_area.
inline RobotSet not_pushed(const Occupancy& occupancy, const ByEnd<ByEnd<RobotSet>>& area,
                           End owner, End team) {
  return area[index_of(owner)][index_of(team)] & ~occupancy.shoved[index_of(team)];
}

}  // namespace mirocup::referee
