// SPDX-License-Identifier: MIT
//
// Attacking: the direction of the shot, getting behind the ball, driving through it, and the places
// where the other robots wait.
//
//                    3 to the open corner
//                   o ----------------->
//      2 through   /
//        the ball /            1 along the field of directions, behind the ball
//          .--->-'
//         '--<-- robot
//
//   shooting_aim    the open corner of the goal, or along a wall
//   is_on_line      whether a robot is behind the ball, on the line of the shot
//   attack_ball     steps 1, 2 and 3
//   attack_ball_at  the same, for a caller that knows where the robot meets the ball
//   supporting_place  between the ball and the own goal, on alternate sides
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/draw.hpp"
#include "mirocup/skills/intercept.hpp"
#include "mirocup/skills/shoot.hpp"
#include "mirocup/skills/univector_field.hpp"

namespace mirocup::strategy {

// Returns the target of a shot from `from`: the open corner or, at a wall, a point along the wall.
inline Point shooting_aim(const Setup& setup, const Observation& now, Point from) {
  const double wall = setup.half_width - 0.05;
  const bool is_at_wall = std::abs(from.y) > wall && from.x < setup.half_length - 0.25;
  if (is_at_wall) return {from.x + 1.0, from.y};
  const bool is_at_own_end = from.x < -setup.half_length + 0.06;
  if (is_at_own_end) return {from.x + 0.2, from.y + (from.y > 0.0 ? 1.0 : -1.0)};
  return open_corner(setup, now, 0.06);
}

// A shot at a ball that will be at `at`, along `along` (of length 1).
struct Shot {
  Point at;          // m
  Point along;       // of length 1
  double aside = 0;  // m: how far the robot is to the left of the line of the shot
  bool is_on_line = false;
};

// Returns the shot of `robot` at a ball that will be at `at`, with the target `aim`.
inline Shot shot_of(const Robot& robot, Point at, Point aim) {
  Shot shot{at, unit(aim - at)};
  const Point from_ball = position(robot) - at;
  const double behind = -dot(from_ball, shot.along);
  shot.aside = shot.along.x * from_ball.y - shot.along.y * from_ball.x;
  shot.is_on_line = behind > 0.0 && behind < 0.4 && std::abs(shot.aside) < 0.02 + 0.35 * behind;
  return shot;
}

// Returns the point to drive to for a robot that is near the line of the shot: the robot comes back
// to the line before it meets the ball, and drives through the ball.
inline Point through(const Shot& shot) {
  return shot.at + 0.3 * shot.along - (2.0 * shot.aside) * Point{-shot.along.y, shot.along.x};
}

// Returns the pose that robot number `me` shall have at the ball.
inline Target pose_at_ball(const Setup& setup, int me, const Shot& shot) {
  return {keep_out(setup, me, inside(setup, shot.at, setup.robot_side / 2.0 + 0.0025)),
          math::atan2(shot.along.y, shot.along.x)};
}

// How a robot drives at the ball.
struct Attack {
  double speed = 1.8;    // m/s
  double sight = 1e9;    // m: robots farther away are not obstacles
  double lead_s = 0.08;  // s: the field of directions is read at the robot's place after this time
};

// Robot `me` meets the ball at `at` and shoots it to `aim`: the robot comes in along a field of
// directions round all other robots, and drives through the ball.
inline Wheels attack_ball_at(const Setup& setup, const Observation& now, int me, Point at,
                             Point aim, const Attack& how = {}) {
  const Robot& robot = now.own[me];
  const Shot shot = shot_of(robot, at, aim);
  if (shot.is_on_line) {
    return drive_to(setup, robot, keep_out(setup, me, through(shot)), how.speed, how.speed);
  }
  const Target target = pose_at_ball(setup, me, shot);
  Obstacle obstacles[2 * MIROCUP_MAX_ROBOTS];
  int count = 0;
  const auto add = [&](const Robot& other) {
    const Point p = position(other);
    const bool is_at_ball = length(p - target.at) < setup.robot_side + 0.025;
    if (is_at_ball || length(p - position(robot)) > how.sight) return;
    obstacles[count++] = {p, {other.vx, other.vy}};
  };
  for (int j = 0; j < now.robots; ++j) {
    add(now.opponent[j]);
    if (j != me) add(now.own[j]);
  }
  return follow_field(setup, robot, target, how.speed, obstacles, count, {}, how.lead_s);
}

// Shoots the moving ball to `aim` from the point at which robot `me` meets it. Draws this point and
// `aim` (draw.hpp).
inline Wheels attack_ball(const Setup& setup, const Observation& now, int me, Point aim,
                          const Attack& how = {}) {
  const Point meet = intercept(setup, now, now.own[me]).ball.at;
  draw_shot(setup, now.own[me], meet, aim);
  return attack_ball_at(setup, now, me, meet, aim, how);
}

// Returns the place of a robot that does not attack: between the ball and the own goal. Rank 0 is
// on the line from ball to goal, 1 beside it, 2 and 3 a row farther back, and so on.
inline Point supporting_place(const Setup& setup, const Observation& now, int me, int rank) {
  const double side = now.ball_y > 0.0 ? -1.0 : 1.0;
  const int row = rank / 2;
  const double back = 0.3 + 0.25 * row;
  // A robot nearer to the own goal would deflect more of the opponents' balls into the goal: with
  // -0.75 here, a team scored twice as many own goals.
  constexpr double deepest = -0.6;  // x, as a part of half the length of the field
  const double x = math::max(deepest * setup.half_length, now.ball_x - back);
  const double part = (x + setup.half_length) / (now.ball_x + setup.half_length + 0.01);
  const double spread = rank % 2 == 0 ? 0.0 : side * (0.3 + 0.1 * row);
  const double y = math::clamp(part, 0.0, 1.0) * now.ball_y + spread;
  // Only one robot may be in the opponents' goal area.
  const double front = setup.half_length - setup.goal_area_depth - (setup.robot_side + 0.055);
  return make_way(setup, now, keep_out(setup, me, inside(setup, {math::min(x, front), y})));
}

}  // namespace mirocup::strategy
