// SPDX-License-Identifier: MIT
//
// A crowd: more robots of a team in an area than a law allows, and for how long. What the laws of
// two and four defenders or attackers measure alike.
#pragma once

#include "core/referee/dwell.hpp"
#include "core/referee/occupancy.hpp"

namespace mirocup::referee {

enum class Side { defenders, attackers };  // of the area

struct CrowdLimit {
  const ByEnd<ByEnd<RobotSet>>& area;  // of the watch
  Side side = Side::defenders;
  int most = 0;                  // robots that may be there; 0: any number
  double patience = 0.0;         // with one too many, s
  double patience_beyond = 0.0;  // with more than that
};

struct Crowd {
  End owner = End::left;  // whose area it is
  RobotSet robots;
  double for_s = 0.0;
};

// Counts the time at both ends, wherever the ball is. The crowd that is there for too long with the
// ball in the zone of that goal, or crossing the line of `goal_at`; nearest to the ball first.
std::optional<Crowd> find_crowd(const Pitch& pitch, const Situation& situation,
                                const Occupancy& occupancy, const CrowdLimit& limit,
                                std::optional<End> goal_at, ByEnd<Dwell>& crowded);

}  // namespace mirocup::referee
