// SPDX-License-Identifier: MIT
//
// Functions that change targets and commands so that robots keep the laws, and do not turn the ball
// into their own goal. Include strategy.hpp instead of this header.
#pragma once

#include "mirocup/driving.hpp"

#include <cmath>

namespace mirocup::strategy {

// Returns the target `p` of robot `i`, moved out of the areas that the laws forbid to the robot:
// the own goal area, in which only the keeper may be, and for robots 3 and higher also the own
// penalty area. Do not call this function for the keeper.
inline Point keep_out(const Setup& setup, int i, Point p) {
  // m: room around the area for its arc and half a robot.
  const double margin = setup.robot_side + (setup.league == MIROCUP_LARGE ? 0.075 : 0.02);
  const bool is_crowd = i >= 3 && setup.penalty_area_depth > 0.0;
  const double depth = (is_crowd ? setup.penalty_area_depth : setup.goal_area_depth) + margin;
  const double half_width =
      (is_crowd ? setup.penalty_area_half_width : setup.goal_area_half_width) + margin;
  if (p.x < -setup.half_length + depth && std::abs(p.y) < half_width) {
    p.x = -setup.half_length + depth;
  }
  return p;
}

// Returns the place `p` of a waiting robot. If the ball is near the own goal and `p` is in front of
// the ball, the place is moved aside, because a ball that the keeper clears would rebound from the
// robot.
inline Point make_way(const Setup& setup, const Observation& now, Point p) {
  const bool is_in_front = now.ball_x < -setup.half_length + setup.goal_area_depth + 0.15 &&
                           p.x > now.ball_x + 0.02 && p.x < now.ball_x + 0.5;
  if (!is_in_front) return p;
  const double aside = setup.goal_half_width + 0.1;
  p.y = p.y < 0.0 ? math::min(p.y, -aside) : math::max(p.y, aside);
  return p;
}

// True if the ball has made no progress for `patience` s and nearly stands, for example between two
// robots, at a wall or in a corner.
inline bool is_stuck(const Observation& now, double patience = 0.6) {
  return now.stalemate_s > patience && length(ball_velocity(now)) < 0.15;
}

// If the robot would push an opponent without playing the ball, returns speeds at which the robot
// slows down before the opponent and backs off. Otherwise returns `wheels` unchanged. A robot at
// the ball counts as playing it: if both robots backed off, the ball would stay.
inline Wheels without_pushing(const Setup& setup, const Observation& now, const Robot& robot,
                              Wheels wheels) {
  const Point here = position(robot);
  const Point nose{math::cos(robot.heading), math::sin(robot.heading)};
  const double forward = setup.wheel_radius * (wheels.left + wheels.right) / 2.0;
  const double turn = setup.wheel_radius * (wheels.right - wheels.left) / setup.wheel_distance;
  const Point direction = (forward < 0.0 ? -1.0 : 1.0) * nose;
  const Point to_ball = ball(now) - here;
  const double wide = setup.robot_side + 0.015;  // m: two robots side by side
  if (length(to_ball) < wide) return wheels;
  const double ball_aside = std::abs(to_ball.x * direction.y - to_ball.y * direction.x);
  const bool ball_ahead =
      dot(to_ball, direction) > 0.0 && ball_aside < setup.robot_side / 2.0 + 0.0175;
  double allowed = std::abs(forward);
  for (int j = 0; j < now.robots; ++j) {
    const Point to = position(now.opponent[j]) - here;
    if (dot(to, direction) <= 0.0 || std::abs(to.x * direction.y - to.y * direction.x) > wide)
      continue;
    // If the ball is between the robot and the opponent, pushing both is playing the ball. A robot
    // that drives to a stuck ball also plays the ball.
    const double nearer = is_stuck(now, 1.0) && length(to_ball) < 0.2 ? 0.04 : 0.0;
    if (ball_ahead && dot(to_ball, direction) < dot(to, direction) + nearer) continue;
    const double gap = length(to) - (setup.robot_side + 0.025);
    allowed = math::min(allowed, gap > 0.0 ? 0.1 + 4.0 * gap : -0.2);
  }
  if (allowed == std::abs(forward)) return wheels;
  return wheels_for(setup, forward < 0.0 ? -allowed : allowed, turn);
}

// If robot `i` is in an area that keep_out() forbids, or will soon be there at its speed, returns
// speeds that take the robot out on the shortest way. Otherwise returns `wheels` unchanged. Do not
// call this function for the keeper.
inline Wheels out_of_area(const Setup& setup, int i, const Robot& robot, Wheels wheels) {
  // m: half a robot, because a robot counts as in the area if more than half of it is inside.
  const double margin = setup.robot_side / 2.0 + 0.0025;
  const double braking_s = 0.1;  // time for the motors and the delay of a tick, s
  const bool is_crowd = i >= 3 && setup.penalty_area_depth > 0.0;
  const double depth = is_crowd ? setup.penalty_area_depth : setup.goal_area_depth;
  const double half_width = is_crowd ? setup.penalty_area_half_width : setup.goal_area_half_width;
  // The arc before the area, m: its height and half its chord.
  const bool has_arc = is_crowd || setup.league == MIROCUP_SMALL;
  const double height = !has_arc ? 0.0 : setup.league == MIROCUP_LARGE ? 0.1 : 0.05;
  const double arc = std::abs(robot.y) < half_width / 2.0 ? height : 0.0;
  const double front = -setup.half_length + depth + arc + margin;
  const double side = half_width + margin;
  const double soon_x = robot.x + braking_s * robot.vx;
  const double soon_y = robot.y + braking_s * robot.vy;
  if (soon_x > front || std::abs(soon_y) > side) return wheels;
  const bool is_near_front = front - robot.x < side - std::abs(robot.y);
  const double beside = robot.y > 0.0 ? side + 0.1 : -side - 0.1;
  return drive_to(setup, robot,
                  is_near_front ? Point{front + 0.1, robot.y} : Point{robot.x, beside});
}

// Applies without_pushing() and out_of_area() to all robots except robot 0, the keeper.
inline void keep_laws(const Setup& setup, const Observation& now, Command& command) {
  for (int i = 1; i < now.robots; ++i) {
    command.wheels[i] = without_pushing(setup, now, now.own[i], command.wheels[i]);
    command.wheels[i] = out_of_area(setup, i, now.own[i], command.wheels[i]);
  }
}

// True if a ball that rolls straight on crosses the own goal line between the posts, or up to
// `margin` (m) beside them.
inline bool rolls_into_own_goal(const Setup& setup, Point ball, Point velocity, double margin) {
  if (velocity.x > -0.05) return false;
  const double seconds = (-setup.half_length - ball.x) / velocity.x;
  return std::abs(ball.y + seconds * velocity.y) < setup.goal_half_width + margin;
}

// True if the ball will meet `robot` within `soon_s` and would rebound from it into the own goal.
inline bool would_turn_ball_in(const Setup& setup, const Observation& now, const Robot& robot,
                               double soon_s = 0.4) {
  const Point velocity = ball_velocity(now);
  const Point coming = velocity - Point{robot.vx, robot.vy};
  const Point along = unit(coming);
  const Point to = position(robot) - ball(now);
  const double ahead = dot(to, along);
  const double aside = along.x * to.y - along.y * to.x;
  const double touch = setup.robot_side / 2.0 + 0.0225;  // m, from the robot's middle to the ball's
  if (ahead < 0.0 || ahead > soon_s * length(coming) + touch) return false;
  if (std::abs(aside) > setup.robot_side + 0.005) return false;
  for (int face = 0; face < 4; ++face) {
    const double heading = robot.heading + face * pi / 2.0;
    const Point normal{math::cos(heading), math::sin(heading)};
    const double closing = -dot(coming, normal);
    if (closing < 0.2 * length(coming)) continue;
    // 1.4 = 1 + 0.4: the ball keeps 0.4 of its closing speed in the impact.
    const Point off = velocity + (1.4 * closing) * normal;
    if (rolls_into_own_goal(setup, position(robot) + touch * normal, off, 0.05)) return true;
  }
  return false;
}

// If a ball in the own half would rebound from a robot other than the keeper into the own goal,
// changes the robot's command: a robot at a slant turns square to the field, and a robot that is
// already square makes way.
inline void avoid_own_goals(const Setup& setup, const Observation& now, Command& command) {
  const Point velocity = ball_velocity(now);
  if (now.ball_x > 0.0 || length(velocity) < 0.25) return;
  if (rolls_into_own_goal(setup, ball(now), velocity, -0.02)) return;  // a rebound cannot be worse
  for (int i = 1; i < now.robots; ++i) {
    const Robot& robot = now.own[i];
    if (!would_turn_ball_in(setup, now, robot)) continue;
    const double error = squared(robot.heading) - robot.heading;
    if (std::abs(error) > 0.15) {
      const double turns_on = robot.turn * (setup.control_period + setup.motor_time_constant);
      command.wheels[i] = wheels_for(setup, 0.0, 16.0 * (error - turns_on));
    } else {
      const Point along = unit(velocity);
      const Point to = position(robot) - ball(now);
      const Point aside = unit(to - dot(to, along) * along);
      const Point nose{math::cos(robot.heading), math::sin(robot.heading)};
      const double way = dot(nose, aside + 0.7 * along) < 0.0 ? -1.0 : 1.0;
      command.wheels[i] = wheels_for(setup, way * 1.5, 9.0 * error);
    }
  }
}

}  // namespace mirocup::strategy
