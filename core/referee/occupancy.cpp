// SPDX-License-Identifier: MIT
#include "core/referee/occupancy.hpp"

#include "core/field/coverage.hpp"
#include "core/referee/predicates.hpp"

#include <algorithm>

namespace mirocup::referee {

namespace {

constexpr double more_than_half = 0.5 + 1e-6;

bool stands_in(const JudgedField& pitch, const field::Area& area, End end, const Pose& robot) {
  return field::covered_part(pitch.field, area, end, robot, pitch.robot_side) > more_than_half;
}

void update_areas(const JudgedField& pitch, const TickFacts& s, Occupancy& occupancy) {
  occupancy.goal_area = {};
  occupancy.penalty_area = {};
  for (const End owner : both_ends) {
    const int area = index_of(owner);
    for (const End team : both_ends) {
      const int t = index_of(team);
      for (int i = 0; i < pitch.field.robots_per_team; ++i) {
        const Pose& robot = s.robots[t][i];
        // Every area is well inside its own half, so a robot with its centre in the other half is
        // not in it.
        if (attack_sign(owner) * robot.position.x() >= 0.0) continue;
        occupancy.goal_area[area][t][i] = stands_in(pitch, pitch.field.goal_area, owner, robot);
        if (!pitch.field.penalty_area) continue;
        occupancy.penalty_area[area][t][i] =
            stands_in(pitch, *pitch.field.penalty_area, owner, robot);
      }
    }
  }
}

void update_keepers(const JudgedField& pitch, const TickFacts& s, Occupancy& occupancy) {
  for (const End end : both_ends) {
    const int e = index_of(end);
    occupancy.keeper[e].reset();
    double longest = -1.0;
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      double& home = occupancy.at_home_s[e][i];
      if (!occupancy.goal_area[e][e][i]) {
        home = 0.0;
        continue;
      }
      home += s.duration;
      if (home <= longest) continue;
      longest = home;
      occupancy.keeper[e] = RobotId{end, i};
    }
  }
}

bool is_shoved(const JudgedField& pitch, const TickFacts& s, const RobotId& robot) {
  const RobotSet touching = s.touched_opponents[index_of(robot.end)][robot.index];
  if (touching.none()) return false;
  for (int j = 0; j < pitch.field.robots_per_team; ++j) {
    if (!touching[j]) continue;
    const RobotId other{opposite(robot.end), j};
    if (drives_at(pitch, s, other, robot) && !drives_at(pitch, s, robot, other)) return true;
  }
  return false;
}

void update_shoves(const JudgedField& pitch, const TickFacts& s, Occupancy& occupancy) {
  for (const End end : both_ends) {
    for (int i = 0; i < pitch.field.robots_per_team; ++i) {
      double& left = occupancy.excused_s[index_of(end)][i];
      left =
          is_shoved(pitch, s, {end, i}) ? pitch.rules.shoved_s : std::max(left - s.duration, 0.0);
      occupancy.shoved[index_of(end)][i] = left > 0.0;
    }
  }
}

}  // namespace

void update_occupancy(const JudgedField& pitch, const TickFacts& s, Occupancy& occupancy) {
  update_areas(pitch, s, occupancy);
  update_keepers(pitch, s, occupancy);
  update_shoves(pitch, s, occupancy);
}

}  // namespace mirocup::referee
