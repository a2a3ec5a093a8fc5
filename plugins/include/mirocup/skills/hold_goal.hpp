// SPDX-License-Identifier: MIT
//
// Goalkeeping of the tactician.
#pragma once

#include "mirocup/skills/ball_path.hpp"
#include "mirocup/skills/drive.hpp"
#include "mirocup/skills/keeper.hpp"

namespace mirocup::strategy {

struct GoalHolding {
  double line = 0.027;          // m, from the goal line to the middle of the keeper
  double inside_post = 0.0385;  // m: the keeper's middle stays so far inside the posts
  double slow = 0.2;            // m/s: a slower ball is cleared
};

// Returns the y at which the keeper has to be.
inline double holding_y(const Setup& setup, const Observation& now, const BallPath& path,
                        const GoalHolding& how = {}) {
  const double front = -setup.half_length + how.line + setup.robot_side / 2.0;
  const double reach = setup.goal_half_width - how.inside_post;
  const Point where = ball(now);
  const double side = where.y < 0.0 ? -1.0 : 1.0;
  const double depth = where.x + setup.half_length;
  // Beside the goal: nothing passes the near post.
  if (depth < how.line + 0.06 && std::abs(where.y) > reach) return side * reach;

  if (now.ball_vx < -0.1) {
    for (double t = 0.0; t < 1.3; t += 0.033) {
      const Point there = path.after(t).at;
      if (there.x > front + setup.ball_radius) continue;
      if (std::abs(there.y) > setup.goal_half_width + 0.08) break;
      return std::clamp(there.y, -reach, reach);
    }
  }
  // A robot runs at a ball that lies: where its shot would go.
  if (length(ball_velocity(now)) < 0.3) {
    for (int j = 0; j < now.robots; ++j) {
      const Robot& shooter = now.opponent[j];
      const Point run{shooter.vx, shooter.vy};
      const Point to_ball = where - position(shooter);
      if (shooter.vx > -0.3 || length(to_ball) > 0.35) continue;
      if (dot(unit(run), unit(to_ball)) < 0.95) continue;
      double along = shooter.heading;
      if (std::cos(along) > 0.0) along += pi;
      return std::clamp(y_on_line(where, {std::cos(along), std::sin(along)}, front), -reach, reach);
    }
  }
  // The bisector of the angle in which the ball sees the goal.
  const double middle = middle_of_goal_view(setup, where);
  const double part = std::clamp(how.line / std::max(depth, 0.001), 0.0, 1.0);
  return std::clamp(middle + part * (where.y - middle), -reach, reach);
}

// Guards the goal. `robot`: at its next command.
inline Wheels hold_goal(const Setup& setup, const Observation& now, const BallPath& path,
                        const Robot& robot, const GoalHolding& how = {}) {
  const Point here = position(robot);
  const MovingBall soon = path.after(0.05);
  const Point to_ball = soon.at - here;
  double nearest = 1.0;
  for (int j = 0; j < now.robots; ++j) {
    nearest = std::min(nearest, length(position(now.opponent[j]) - ball(now)));
  }
  const bool is_slow = length(ball_velocity(now)) < how.slow;
  const bool is_in_area = now.ball_x < -setup.half_length + setup.goal_area_depth + 0.03 &&
                          std::abs(now.ball_y) < setup.goal_area_half_width + 0.03;
  const double outwards = now.ball_y >= 0.0 ? 1.0 : -1.0;
  const bool is_free = nearest > 0.15;
  // A ball that lies free before the keeper: away with it. Not inwards.
  if (is_in_area && is_slow && is_free && to_ball.x > -0.02 && length(to_ball) < 0.25) {
    const bool is_outer = outwards * to_ball.y > -0.02;
    const bool is_before = to_ball.x > 0.045;
    if (is_before || is_outer) {
      const double course = std::atan2(to_ball.y, std::max(0.0, to_ball.x));
      return head_for(setup, robot, course, 1.8);
    }
  }
  // Before its face, and somebody is there: spin it to the nearer side.
  if (is_in_area && is_slow && !is_free && to_ball.x > 0.045 && length(to_ball) < 0.075 &&
      std::abs(now.ball_y) < setup.goal_half_width) {
    return wheels_turning_first(setup, 0.0, outwards * 25.0);
  }
  const double y = holding_y(setup, now, path, how);
  // Beside the goal the ball rolls along the end wall. A keeper that meets it with the middle of
  // its face is not turned by it, so it stands deeper, and pushes outwards.
  const bool is_beside = soon.at.x + setup.half_length < 0.045 &&
                         std::abs(soon.at.y) > setup.goal_half_width - 0.07 &&
                         std::abs(soon.at.y) < 0.42;
  const double depth = how.line;
  const Point post{-setup.half_length + depth, y};
  if (is_beside && std::abs(here.x - post.x) < 0.02 && outwards * to_ball.y > 0.03 &&
      outwards * to_ball.y < 0.075) {
    const double upright = robot.heading > 0.0 ? pi / 2.0 : -pi / 2.0;
    return wheels_turning_first(setup, (robot.heading > 0.0 ? 1.8 : -1.8) * outwards,
                                turn_for(setup, robot.turn, wrapped(upright - robot.heading)));
  }
  const Point to = post - here;
  // Off its line: back, round the ball.
  if (std::abs(to.x) > 0.03 || std::abs(here.y) > setup.goal_half_width + 0.06) {
    const Point way = unit(to);
    const double ahead = dot(to_ball, way);
    const double aside = way.x * to_ball.y - way.y * to_ball.x;
    if (ahead > 0.0 && ahead < length(to) && std::abs(aside) < 0.07) {
      const double turn = aside > 0.0 ? -1.0 : 1.0;
      const Point beside = soon.at + (0.09 * turn) * Point{-way.y, way.x};
      return drive_quickly(setup, robot, inside(setup, beside), 0.5);
    }
    return drive_quickly(setup, robot, post);
  }
  // Along the line; a little steering keeps it there.
  const double upright = robot.heading > 0.0 ? pi / 2.0 : -pi / 2.0;
  const double way = robot.heading > 0.0 ? 1.0 : -1.0;
  const double moving = speed_ahead(robot);
  const double distance = way * to.y;
  const double forward =
      (0.9 * distance - setup.motor_time_constant * moving) / setup.control_period;
  const double steer = std::clamp(4.0 * to.x * (moving > 0.0 ? 1.0 : -1.0), -0.3, 0.3) *
                       std::min(1.0, std::abs(moving) / 0.2);
  const double error = wrapped(upright - way * steer - robot.heading);
  return wheels_turning_first(setup,
                              std::clamp(forward, -1.8, 1.8) * std::max(0.0, std::cos(2.0 * error)),
                              turn_for(setup, robot.turn, error));
}

}  // namespace mirocup::strategy
