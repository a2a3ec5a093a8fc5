// SPDX-License-Identifier: MIT
//
// Goalkeeping: the keeper stays on a line before its goal, at the point where the ball, also after
// rebounds from walls, will cross the line. It clears a slow ball to the side, never across its own
// goal.
//
//   cover_point   the place on its line at which the keeper has to be
//   guard_goal    drives to the cover point, and clears
//   rough_guard   a keeper for predictions: cheaper, and clears nothing
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/ball_path.hpp"
#include "mirocup/skills/draw.hpp"
#include "mirocup/skills/shoot.hpp"

#include <optional>

namespace mirocup::strategy {

struct KeeperHabits {
  double line = 0.05;        // m, from the goal line to the middle of the keeper
  double inside_post = 0.0;  // m: the keeper's middle stays this far inside the posts
  double clear_speed = 0.5;  // m/s: a slower ball in the goal area is cleared
  double spin = 25.0;        // rad/s, to throw away a ball that lies before the keeper
};

// Returns the y, m, at which the line through `ball` along `direction` reaches `x` (m).
inline double y_on_line(Point ball, Point direction, double x) {
  return ball.y + (x - ball.x) / direction.x * direction.y;
}

// If an opponent drives at a slow ball, returns the y, m, at which its shot will reach `x` (m);
// otherwise returns no value.
inline std::optional<double> y_of_coming_shot(const Observation& now, double x) {
  if (length(ball_velocity(now)) >= 0.3) return std::nullopt;
  for (int j = 0; j < now.robots; ++j) {
    const Robot& shooter = now.opponent[j];
    const Point run{shooter.vx, shooter.vy};
    const Point to_ball = ball(now) - position(shooter);
    if (shooter.vx > -0.3 || length(to_ball) > 0.35) continue;
    if (dot(unit(run), unit(to_ball)) < 0.95) continue;
    // The ball leaves the face that hits it at a right angle.
    double along = shooter.heading;
    if (math::cos(along) > 0.0) along += pi;
    return y_on_line(ball(now), {math::cos(along), math::sin(along)}, x);
  }
  return std::nullopt;
}

// Returns the place on the keeper's line from which the keeper covers the goal.
inline Point cover_point(const Setup& setup, const Observation& now,
                         const KeeperHabits& habits = {}) {
  const double line = -setup.half_length + habits.line;
  const double reach = setup.goal_half_width - habits.inside_post;
  const auto at = [&](double y) { return Point{line, math::clamp(y, -reach, reach)}; };
  // The x of the ball's middle when the ball meets the face that looks into the field. If the
  // keeper stood where the ball crosses the line, a ball from the side would meet another face,
  // which turns the ball into the goal.
  const double front = line + setup.robot_side / 2.0 + setup.ball_radius;
  const Point where = ball(now);

  // If the ball comes, the keeper covers the place where it will arrive.
  if (now.ball_vx < -0.15) {
    const Crossing crossing = time_at_x(setup, moving_ball(now), front);
    if (crossing.is_ahead && std::abs(crossing.y) < setup.goal_half_width + 0.1) {
      return at(crossing.y);
    }
  }
  if (const auto y = y_of_coming_shot(now, front)) return at(*y);
  // If the ball does not come, the keeper stands on the bisector of the angle between the posts, as
  // seen from the ball.
  const double middle = middle_of_goal_view(setup, where);
  const double part = math::clamp(habits.line / (where.x + setup.half_length), 0.0, 1.0);
  return at(middle + part * (where.y - middle));
}

// Guards the goal, and draws the keeper's target (draw.hpp).
inline Wheels guard_goal(const Setup& setup, const Observation& now, const Robot& robot,
                         const KeeperHabits& habits = {}) {
  const Point here = position(robot);
  const Point to_ball = ball(now) - here;
  const double outwards = now.ball_y >= 0.0 ? 1.0 : -1.0;

  const bool is_slow = length(ball_velocity(now)) < habits.clear_speed;
  const bool is_in_area = now.ball_x < -setup.half_length + setup.goal_area_depth + 0.03 &&
                          std::abs(now.ball_y) < setup.goal_area_half_width + 0.03;
  if (is_slow && is_in_area) {
    // The ball is before the keeper: spin, so that the keeper's face throws the ball towards the
    // nearer side wall.
    if (to_ball.x > 0.4 * setup.robot_side && length(to_ball) < setup.robot_side + 0.005) {
      return wheels_for(setup, 0.0, outwards * habits.spin);
    }
    // The ball is beside the keeper at the end wall: push the ball along the wall.
    if (std::abs(to_ball.x) < 0.05 && outwards * to_ball.y > 0.0 &&
        length(to_ball) < setup.robot_side + 0.085) {
      return slide_to(setup, robot, now.ball_y + 0.1 * outwards, 1.2);
    }
    // The ball is farther away, before the keeper, and nearer than the keeper to a side wall: push
    // the ball out of the area.
    const bool is_outer = outwards * to_ball.y > -0.01;
    if (to_ball.x > -0.02 && is_outer && length(to_ball) < 0.3) {
      return drive_to(setup, robot, ball(now) + Point{0.1, 0.15 * outwards}, 1.2);
    }
  }

  const Point post = cover_point(setup, now, habits);
  draw_target(setup, robot, post);
  const Point to = post - here;
  if (std::abs(to.x) > 0.05 || std::abs(here.y) > setup.goal_half_width + 0.08) {
    return drive_round(setup, robot, post, ball(now), 0.0, 1.5);
  }
  if (std::abs(to.y) < 0.006 && std::abs(to.x) < 0.015) {
    return turn_to(setup, robot, robot.heading > 0.0 ? pi / 2.0 : -pi / 2.0);
  }
  const double speed = math::min(1.8, 7.0 * std::abs(to.y) + 0.05);
  const LineFollowing how{.aim_ahead = 0.08};
  return follow_line(setup, robot, post, to.y > 0.0 ? pi / 2.0 : -pi / 2.0, speed, how);
}

// Stays on the line before the goal, where the ball will cross the line after at most one rebound
// from a side wall. This function is for teams that ask hundreds of times in a tick.
inline Wheels rough_guard(const Setup& setup, const Observation& now, const Robot& robot) {
  const double line = -setup.half_length + 0.05;
  double y = now.ball_y * 0.3;
  if (now.ball_vx < -0.15 && now.ball_x > line) {
    const double width = setup.half_width - setup.ball_radius;
    y = now.ball_y +
        now.ball_vy * (line + (setup.robot_side / 2.0 + 0.0225) - now.ball_x) / now.ball_vx;
    if (std::abs(y) > width) y = std::copysign(2.0 * width - std::abs(y), y);
  }
  const Point post{line, math::clamp(y, -setup.goal_half_width, setup.goal_half_width)};
  const Point to = post - position(robot);
  if (std::abs(to.x) > 0.05) return drive_to(setup, robot, post);
  const double speed = math::min(1.8, 7.0 * std::abs(to.y));
  return follow_line(setup, robot, post, to.y > 0.0 ? pi / 2.0 : -pi / 2.0, speed,
                     {.aim_ahead = 0.08});
}

}  // namespace mirocup::strategy
