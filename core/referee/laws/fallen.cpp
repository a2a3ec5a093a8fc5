// SPDX-License-Identifier: MIT
#include "core/referee/laws/fallen.hpp"

#include "core/referee/touches.hpp"

#include <algorithm>

namespace mirocup::referee {

namespace {

// True if the ball cannot pass between the robot and the line of that goal.
bool blocks(const JudgedField& pitch, const Pose& robot, End goal) {
  const field::Field& field = pitch.field;
  const Vec2 on_line{-attack_sign(goal) * field.half_length,
                     std::clamp(robot.position.y(), -field.goal_half_width, field.goal_half_width)};
  return ball_gap(pitch, on_line, robot) <= 0.0;
}

}  // namespace

std::optional<Decision> judge_fallen(const JudgedField& pitch, const TickFacts& s) {
  for (const End end : ends_from_ball(s)) {
    const RobotSet& fallen = s.fallen[index_of(end)];
    for (int i = 0; i < pitch.field.robots_per_team && fallen.any(); ++i) {
      const RobotId robot{end, i};
      if (!fallen[i]) continue;
      for (const End goal : both_ends) {
        if (!blocks(pitch, s.pose(robot), goal)) continue;
        Decision d = decide(Verdict::RESTART, Law::fallen, s,
                            name_of(robot) + " lies before the " + std::string(to_string(goal)) +
                                " goal; play goes on from the same positions when it stands");
        d.team = end;
        d.add_robot(robot);
        return d;
      }
    }
  }
  return std::nullopt;
}

}  // namespace mirocup::referee
