// SPDX-License-Identifier: MIT
//
// Keeping the laws that the helpers of strategy.hpp do not know.
//
//   is_simurosot       whether the rules are those of SimuroSot
//   is_vsss            whether the rules are those of VSSS
//   spare_keeper       brakes before the opponents' keeper
//   must_leave_area    whether a robot that does not attack has to leave the opponents' goal area
//   leave_area         drives out of that area
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/strategy.hpp"

#include <cmath>

namespace mirocup::strategy {

// The control period tells the rules of a leg: 1/60 s under SimuroSot rules, 16 ms under VSSS
// rules, 33 ms under MiroSot rules.
inline bool is_simurosot(const Setup& setup) {
  return std::abs(setup.control_period - 1.0 / 60.0) < 1e-4;
}
inline bool is_vsss(const Setup& setup) {
  return std::abs(setup.control_period - 0.016) < 1e-4;
}

struct Distance {
  double gap = 0.11;        // m between the middles; a nearer attacker backs off
  double speed = 0.3;       // m/s, allowed at that gap
  double rate = 3.5;        // 1/s: additional speed for each metre beyond the gap
  double slant = 0.3;       // cosine of the angle from motion to keeper; above: the robot slows
  double with_ball = 0.45;  // m/s, allowed with the ball between the two
  double retreat = 0.0;     // m: the robot backs off from a nearer keeper, even if the keeper comes
};

// Returns the distances to keep under the rules of a leg. Under SimuroSot rules each touch of a
// keeper is a foul.
inline Distance keeper_distance(const Setup& setup) {
  if (!is_simurosot(setup)) return {.gap = setup.robot_side + 0.035};
  return {.gap = 0.12, .speed = 0.0, .rate = 4.0, .slant = 0.0, .with_ball = 0.2, .retreat = 0.135};
}

// True if the ball is at the robot, on the side to which `to`, a vector from the robot, points.
inline bool has_ball(const Setup& setup, const Observation& now, const Robot& robot, Point to) {
  const Point to_ball = ball(now) - position(robot);
  return length(to_ball) < setup.robot_side + 0.01 && dot(unit(to_ball), unit(to)) > 0.7;
}

// Slows down all robots but the own keeper before the opponents' keeper; slows a robot less if the
// ball is between it and the keeper. Touching a keeper without playing the ball costs a goal kick.
inline void spare_keeper(const Setup& setup, const Observation& now, Command& command,
                         const Distance& keep) {
  for (int j = 0; j < now.robots; ++j) {
    // The keeper's place at about the time at which the command is driven.
    const Robot& other = now.opponent[j];
    const Point keeper = position(other) + 0.05 * Point{other.vx, other.vy};
    const bool is_home = keeper.x > setup.half_length - setup.goal_area_depth - 0.05 &&
                         std::abs(keeper.y) < setup.goal_area_half_width;
    if (!is_home) continue;
    for (int i = 1; i < now.robots; ++i) {
      const Robot& robot = now.own[i];
      const Point to = keeper - position(robot);
      const double distance = length(to);
      if (distance > 0.6) continue;
      Wheels& wheels = command.wheels[i];
      const double forward = setup.wheel_radius * (wheels.left + wheels.right) / 2.0;
      const double turn = setup.wheel_radius * (wheels.right - wheels.left) / setup.wheel_distance;
      const Point nose{math::cos(robot.heading), math::sin(robot.heading)};
      const double closing = dot((forward < 0.0 ? -1.0 : 1.0) * nose, unit(to));
      if (distance < keep.retreat && !has_ball(setup, now, robot, to)) {
        const double away = dot(nose, to) > 0.0 ? -0.6 : 0.6;
        wheels = wheels_for(setup, away, 0.0);
        continue;
      }
      if (closing < keep.slant) continue;
      const double gap = distance - keep.gap;
      double allowed = gap > 0.0 ? keep.speed + keep.rate * gap : -0.3;
      if (has_ball(setup, now, robot, to)) allowed = math::max(allowed, keep.with_ball);
      if (std::abs(forward) <= allowed) continue;
      wheels = wheels_for(setup, forward < 0.0 ? -allowed : allowed, turn);
    }
  }
}

// The same with the distances of the rules. VSSS rules allow an attacker to charge a keeper.
inline void spare_keeper(const Setup& setup, const Observation& now, Command& command) {
  if (is_vsss(setup)) return;
  spare_keeper(setup, now, command, keeper_distance(setup));
}

// True if a robot that does not attack is about to be in the opponents' goal area, in which only
// one robot may be. A team whose robots keep away scores less. Keeping away pays only under
// SimuroSot rules: the referee then often calls this foul.
inline bool must_leave_area(const Setup& setup, const Robot& robot) {
  if (!is_simurosot(setup)) return false;
  return robot.x + 0.1 * robot.vx > setup.half_length - setup.goal_area_depth - 0.1 &&
         std::abs(robot.y + 0.1 * robot.vy) < setup.goal_area_half_width + 0.05;
}

inline Wheels leave_area(const Setup& setup, const Robot& robot) {
  return drive_to(setup, robot, {setup.half_length - setup.goal_area_depth - 0.2, robot.y});
}

}  // namespace mirocup::strategy
