// SPDX-License-Identifier: MIT
//
// Goalkeeping from the mouth of the goal. The keeper stands so deep that a ball which rolls along
// the end wall meets the middle of the keeper's face. If the keeper stands farther out, such a ball
// meets its corner, turns the keeper aside, and rolls in: half of all goals against a keeper 5 cm
// before its line fell in this way.
//
//        |                |
//   goal | K  <- ball     | K         beside the goal: at the near post, looking along the line,
//        |                +-----      and pushing outwards
//        |                o  <- attacker
//
//   holding_y   the y in the mouth at which the keeper has to be
//   hold_goal   drives there, and clears a ball before the keeper
//
// hold_goal() takes the robot's state at its next command (drive.hpp). Frames and units are those
// of strategy.h.
#pragma once

#include "mirocup/skills/ball_path.hpp"
#include "mirocup/skills/draw.hpp"
#include "mirocup/skills/drive.hpp"
#include "mirocup/skills/keeper.hpp"

namespace mirocup::strategy {

struct GoalHolding {
  double line = 0.027;          // m, from the goal line to the middle of the keeper
  double inside_post = 0.0385;  // m: the keeper's middle stays this far inside the posts
  double slow = 0.2;            // m/s: a slower ball is cleared
  double patience = 1.0;        // s, until the keeper spins at a ball stuck beside the goal
};

// Returns the y at which the keeper has to be.
inline double holding_y(const Setup& setup, const Observation& now, const BallPath& path,
                        const GoalHolding& how = {}) {
  const double front = -setup.half_length + how.line + setup.robot_side / 2.0 + setup.ball_radius;
  const double reach = setup.goal_half_width - how.inside_post;
  const Point where = ball(now);
  const double side = where.y < 0.0 ? -1.0 : 1.0;
  const double depth = where.x + setup.half_length;
  // If the ball is beside the goal, the keeper closes the near post.
  if (depth < how.line + (setup.robot_side / 2.0 + 0.0225) && std::abs(where.y) > reach)
    return side * reach;

  // The y of the ball's middle when the ball meets the face that looks into the field. If the
  // keeper stood where the ball would cross the goal line, a ball from the side would meet another
  // face, which turns the ball into the goal.
  if (now.ball_vx < -0.1) {
    const double step = 0.033;  // s
    const double speed = length(ball_velocity(now));
    double earlier = 0.0;
    for (double t = 0.0; t < 1.3; earlier = t, t += step) {
      if (speed * t < where.x - front) continue;  // rolling and rebounds only slow it
      const Point there = path.after(t).at;
      if (there.x > front) continue;
      const Point before = t == 0.0 ? where : path.after(earlier).at;
      const double gone = before.x - there.x;
      const double part = gone > 1e-6 ? (before.x - front) / gone : 1.0;
      const double y = before.y + math::clamp(part, 0.0, 1.0) * (there.y - before.y);
      if (std::abs(y) > setup.goal_half_width + 0.08) break;
      return math::clamp(y, -reach, reach);
    }
  }
  if (const auto y = y_of_coming_shot(now, front)) return math::clamp(*y, -reach, reach);
  // The keeper stands on the bisector of the angle between the posts, as seen from the ball.
  const double middle = middle_of_goal_view(setup, where);
  const double part = math::clamp(how.line / math::max(depth, 0.001), 0.0, 1.0);
  return math::clamp(middle + part * (where.y - middle), -reach, reach);
}

// True if a slow ball lies in the own goal area.
inline bool lies_in_area(const Setup& setup, const Observation& now, double slow) {
  return length(ball_velocity(now)) < slow &&
         now.ball_x < -setup.half_length + setup.goal_area_depth + 0.03 &&
         std::abs(now.ball_y) < setup.goal_area_half_width + 0.03;
}

// Drives along the goal line to the target's y and looks along the line; a little steering keeps
// the robot at the target's x.
inline Wheels slide_quickly(const Setup& setup, const Robot& robot, Point target) {
  const Point to = target - position(robot);
  const double way = robot.heading > 0.0 ? 1.0 : -1.0;
  const double moving = speed_ahead(robot);
  const double wanted =
      (0.9 * way * to.y - setup.motor_time_constant * moving) / setup.control_period;
  const double most = greatest_speed(setup);
  const double steer = math::clamp(4.0 * to.x * (moving > 0.0 ? 1.0 : -1.0), -0.3, 0.3) *
                       math::min(1.0, std::abs(moving) / 0.2);
  const double error = wrapped(way * (pi / 2.0 - steer) - robot.heading);
  const double forward = math::clamp(wanted, -most, most) * math::max(0.0, math::cos(2.0 * error));
  return wheels_turning_first(setup, forward, turn_for(setup, robot.turn, error));
}

// Pushes a ball outwards along the end wall.
inline Wheels push_outwards(const Setup& setup, const Robot& robot, double outwards) {
  const double way = robot.heading > 0.0 ? 1.0 : -1.0;
  const double error = wrapped(way * pi / 2.0 - robot.heading);
  return wheels_turning_first(setup, way * outwards * greatest_speed(setup),
                              turn_for(setup, robot.turn, error));
}

// Drives around the ball back to the goal line, so that the ball stays.
inline Wheels return_to(const Setup& setup, const Robot& robot, Point post, Point ball) {
  const Point to = post - position(robot);
  const Point to_ball = ball - position(robot);
  const Point way = unit(to);
  const double ahead = dot(to_ball, way);
  const double aside = way.x * to_ball.y - way.y * to_ball.x;
  if (ahead <= 0.0 || ahead >= length(to) || std::abs(aside) >= setup.robot_side / 2.0 + 0.0325) {
    return drive_quickly(setup, robot, post);
  }
  const double turn = aside > 0.0 ? -1.0 : 1.0;
  const Point beside = ball + ((setup.robot_side + 0.015) * turn) * Point{-way.y, way.x};
  return drive_quickly(setup, robot, inside(setup, beside), 0.5);
}

// Guards the goal, and draws the keeper's target (draw.hpp).
inline Wheels hold_goal(const Setup& setup, const Observation& now, const BallPath& path,
                        const Robot& robot, const GoalHolding& how = {}) {
  const Point here = position(robot);
  const Point soon = path.after(0.05).at;
  const Point to_ball = soon - here;
  const double outwards = now.ball_y >= 0.0 ? 1.0 : -1.0;
  const double width = setup.goal_half_width;

  double nearest = 1.0;  // m, from the ball to an opponent
  for (int j = 0; j < now.robots; ++j) {
    nearest = math::min(nearest, length(position(now.opponent[j]) - ball(now)));
  }
  if (lies_in_area(setup, now, how.slow)) {
    const bool is_before = to_ball.x > 0.6 * setup.robot_side;
    const bool is_outer = to_ball.x > -0.02 && outwards * to_ball.y > -0.02;
    // No opponent is near: push the ball away, not inwards.
    if (nearest > 0.15 && length(to_ball) < 0.25 && (is_before || is_outer)) {
      return head_for(setup, robot, math::atan2(to_ball.y, math::max(0.0, to_ball.x)), 1.8);
    }
    // An opponent presses the ball against the keeper's face: spin it to the nearer side.
    if (nearest <= 0.15 && is_before && length(to_ball) < setup.robot_side &&
        std::abs(now.ball_y) < width) {
      return wheels_turning_first(setup, 0.0, outwards * 25.0);
    }
  }
  const Point post{-setup.half_length + how.line, holding_y(setup, now, path, how)};
  draw_target(setup, robot, post);
  const bool is_beside = soon.x < -setup.half_length + 0.045 && std::abs(soon.y) > width - 0.07 &&
                         std::abs(soon.y) < width + 0.22;
  const double gap = outwards * to_ball.y;
  if (is_beside && std::abs(here.x - post.x) < 0.02 && gap > 0.4 * setup.robot_side &&
      gap < setup.robot_side) {
    // A ball that is pressed from both sides stays; a spin throws it along the keeper's side.
    if (is_stuck(now, how.patience)) {
      return wheels_turning_first(setup, 0.0, -outwards * 25.0);
    }
    return push_outwards(setup, robot, outwards);
  }
  if (std::abs(post.x - here.x) > 0.03 || std::abs(here.y) > width + 0.06) {
    return return_to(setup, robot, post, soon);
  }
  return slide_quickly(setup, robot, post);
}

}  // namespace mirocup::strategy
