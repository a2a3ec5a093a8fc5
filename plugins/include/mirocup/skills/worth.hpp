// SPDX-License-Identifier: MIT
//
// The worth of a scene, for a team that tries moves before it makes them. The worth depends on
// place and motion of the ball and on the robot that is first behind the ball. On its scale a goal
// for the team is worth about 1, a goal against it about -1.
//
//   worth_of             the worth of a scene in play
//   time_to_get_behind   about the time until a robot is behind the ball, s
//   out_of_reach         whether a ball that goes in passes all robots of a team
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/ball_path.hpp"

namespace mirocup::strategy {

// Returns whether a ball that is about to roll into a goal at `ball` is out of reach of a team: 0
// if a robot is within 5 cm of its path, 1 if no robot is within 20 cm, linear in between.
inline double out_of_reach(const Robot* robots, int count, Point ball) {
  double nearest = 1.0;
  for (int i = 0; i < count; ++i) {
    if (std::abs(robots[i].x - ball.x) > 0.25) continue;
    nearest = math::min(nearest, std::abs(robots[i].y + 0.1 * robots[i].vy - ball.y));
  }
  return math::clamp((nearest - 0.05) / 0.15, 0.0, 1.0);
}

// Returns about how long, s, a robot takes until the ball is between it and `goal`.
inline double time_to_get_behind(const Robot& robot, Point ball, Point goal) {
  const Point along = unit(goal - ball);
  const Point to = ball - 0.06 * along - position(robot);
  const double before = math::max(0.0, dot(position(robot) - ball, along));
  const double turned = std::abs(math::sin(math::atan2(along.y, along.x) - robot.heading));
  return length(to) / 1.3 + 0.5 * math::min(before, 0.15) + 0.08 * turned;
}

inline double worth_of(const Setup& setup, const Observation& now) {
  const double half = setup.half_length;
  const MovingBall later = rolled(setup, moving_ball(now), 0.5);
  if (later.at.x > half) return 0.35 + 0.3 * out_of_reach(now.opponent, now.robots, later.at);
  if (later.at.x < -half) return -0.5 - 0.3 * out_of_reach(now.own, now.robots, later.at);
  const MovingBall soon = rolled(setup, moving_ball(now), 0.2);
  const auto near = [&](double x) {
    const Point goal{x, math::clamp(soon.at.y, -0.1, 0.1)};
    return math::exp(-length(soon.at - goal) / 0.35);
  };
  double worth = 0.2 * soon.at.x / half + 0.25 * (near(half) - near(-half));
  double own = 1e9, opponent = 1e9;
  bool is_covered = false;
  for (int i = 1; i < now.robots; ++i) {
    own = math::min(own, time_to_get_behind(now.own[i], soon.at, {half, 0.0}));
    opponent = math::min(opponent, time_to_get_behind(now.opponent[i], soon.at, {-half, 0.0}));
    is_covered |= now.own[i].x < soon.at.x - 0.1;
  }
  worth += 0.2 * math::clamp((opponent - own) / 0.4, -1.0, 1.0);
  return is_covered ? worth : worth - 0.05;
}

}  // namespace mirocup::strategy
