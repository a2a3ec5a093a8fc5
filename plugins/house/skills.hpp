// SPDX-License-Identifier: MIT
//
// What the house teams do alike: keep the goal, kick off, go home without taking the ball along,
// and keep to the laws.
#pragma once

#include "mirocup/strategy.hpp"

namespace house {

// Is the ball still on the spot of a kick-off of ours? It has to go backwards first.
inline bool must_kick_off(const mirocup_observation& now) {
  return now.restart == MIROCUP_KICK_OFF && now.own_restart != 0 &&
         std::hypot(now.ball_x, now.ball_y) < 0.055;
}

// Nudges it home and aside, so slowly that it does not roll to the own goal.
inline mirocup_wheels kick_off(const mirocup_setup& setup, const mirocup_robot& robot) {
  return mirocup::strategy::drive_to(setup, robot, {-0.2, 0.1}, 0.2, 0.2);
}

// Where a robot other than the keeper may go: not into its own goal area, which is the keeper's,
// and from the third on not into the penalty area either.
inline mirocup::strategy::Point keep_out(const mirocup_setup& setup, int i,
                                         mirocup::strategy::Point p) {
  const double margin = 0.095;  // the arc in front of the area, and half a robot
  const bool crowd = i >= 3 && setup.penalty_area_depth > 0.0;
  const double depth = (crowd ? setup.penalty_area_depth : setup.goal_area_depth) + margin;
  const double half_width =
      (crowd ? setup.penalty_area_half_width : setup.goal_area_half_width) + margin;
  if (p.x < -setup.half_length + depth && std::abs(p.y) < half_width) {
    p.x = -setup.half_length + depth;
  }
  return p;
}

// The same wheels, unless they would push an opponent without playing the ball: then the robot
// slows down before it and backs off.
inline mirocup_wheels without_pushing(const mirocup_setup& setup, const mirocup_observation& now,
                                      const mirocup_robot& robot, mirocup_wheels wheels) {
  using namespace mirocup::strategy;
  const Point here = position(robot);
  const Point nose{std::cos(robot.heading), std::sin(robot.heading)};
  const double forward = setup.wheel_radius * (wheels.left + wheels.right) / 2.0;
  const double turn = setup.wheel_radius * (wheels.right - wheels.left) / setup.wheel_distance;
  const Point way = (forward < 0.0 ? -1.0 : 1.0) * nose;
  const Point to_ball = ball(now) - here;
  const bool ball_ahead =
      dot(to_ball, way) > 0.0 && std::abs(to_ball.x * way.y - to_ball.y * way.x) < 0.055;
  double allowed = std::abs(forward);
  for (int j = 0; j < now.robots; ++j) {
    const Point to = position(now.opponent[j]) - here;
    if (dot(to, way) <= 0.0 || std::abs(to.x * way.y - to.y * way.x) > 0.09) continue;
    // The ball before it and the opponent behind that: to push both is playing.
    if (ball_ahead && dot(to_ball, way) < dot(to, way)) continue;
    const double gap = length(to) - 0.1;
    allowed = std::min(allowed, gap > 0.0 ? 0.1 + 4.0 * gap : -0.2);
  }
  if (allowed == std::abs(forward)) return wheels;
  return wheels_for(setup, forward < 0.0 ? -allowed : allowed, turn);
}

// All robots of a command but the keeper, which holds its place.
inline void keep_laws(const mirocup_setup& setup, const mirocup_observation& now,
                      mirocup_command& command) {
  for (int i = 1; i < now.robots; ++i) {
    command.wheels[i] = without_pushing(setup, now, now.own[i], command.wheels[i]);
  }
}

// Drives to a point, and round a place that is in the way.
inline mirocup_wheels drive_round(const mirocup_setup& setup, const mirocup_robot& robot,
                                  mirocup::strategy::Point target,
                                  mirocup::strategy::Point obstacle, double arrival,
                                  double fastest) {
  using namespace mirocup::strategy;
  const double berth = 0.11;
  const Point here = position(robot);
  const Point way = target - here;
  const Point to = obstacle - here;
  const Point along = unit(way);
  const double ahead = dot(to, along);
  const double aside = along.x * to.y - along.y * to.x;
  if (ahead <= 0.0 || ahead >= length(way) || std::abs(aside) >= berth) {
    return drive_to(setup, robot, target, arrival, fastest);
  }
  // Too near to turn past it: back off first.
  if (length(to) < 0.115) return drive_to(setup, robot, here - 0.1 * unit(to), 0.0, fastest);
  const double side = aside > 0.0 ? -1.0 : 1.0;
  const Point beside = obstacle + (side * berth * 1.2) * Point{-along.y, along.x};
  return drive_to(setup, robot, beside, 0.3, std::min(fastest, 0.9));
}

// Drives to a point, and round what is in the way: a robot on its way home must not push the ball
// there, and nobody may push an opponent.
inline mirocup_wheels drive_clear(const mirocup_setup& setup, const mirocup_observation& now,
                                  const mirocup_robot& robot, mirocup::strategy::Point target,
                                  double arrival = 0.0, double fastest = 1.5) {
  using namespace mirocup::strategy;
  const Point here = position(robot);
  Point obstacle = ball(now);
  for (int j = 0; j < now.robots; ++j) {
    const Point p = position(now.opponent[j]);
    if (length(p - here) < 0.2 && length(p - here) < length(obstacle - here) &&
        dot(p - here, target - here) > 0.0) {
      obstacle = p;
    }
  }
  return drive_round(setup, robot, target, obstacle, arrival, fastest);
}

// Stays on a line before the goal where the ball will cross it, and kicks out what lies near.
inline mirocup_wheels keep_goal(const mirocup_setup& setup, const mirocup_observation& now,
                                const mirocup_robot& robot) {
  using namespace mirocup::strategy;
  const double line = -setup.half_length + 0.055;
  const Point here = position(robot);
  const Point away = ball(now) - here;

  const bool is_slow = length(ball_velocity(now)) < 0.4;
  const bool is_in_reach = now.ball_x > here.x + 0.02 && length(away) < 0.16 &&
                           now.ball_x < -setup.half_length + setup.goal_area_depth + 0.02;
  if (is_slow && is_in_reach) return drive_to(setup, robot, ball(now) + 0.2 * unit(away), 1.0);

  // Where the ball will cross the line, if it comes.
  double y = now.ball_y;
  if (now.ball_vx < -0.1) {
    const double seconds = (line - now.ball_x) / now.ball_vx;
    if (seconds > 0.0 && seconds < 1.5) y = now.ball_y + now.ball_vy * seconds;
  }
  const double reach = setup.goal_half_width - 0.02;
  const Point post{line, std::clamp(y, -reach, reach)};
  if (length(post - here) < 0.01)
    return turn_to(setup, robot, robot.heading > 0.0 ? pi / 2.0 : -pi / 2.0);
  return drive_round(setup, robot, post, ball(now), 0.0, 1.5);
}

}  // namespace house
