// SPDX-License-Identifier: MIT
//
// Penalties. A good keeper reads the run-up: it stands where a shot along the kicker's heading
// would arrive. So the kicker runs up towards one corner. If the keeper goes to that corner, the
// kicker turns to the other corner just before the ball.
//
//        keeper goes along ->  K
//   post ----------------------+--- post
//           \                 :
//            \  the shot     :  the run-up
//             \             :
//              \--- o <-. :
//                      kicker
//
//   PenaltyTaker   where the kicker stands, and how it runs and shoots
//
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/skills/drive.hpp"
#include "mirocup/skills/shoot.hpp"

namespace mirocup::strategy {

struct PenaltyHabits {
  double run_up = 0.35;     // m, from the middle of the kicker to the middle of the ball
  double turn_from = 0.18;  // m: at this distance from the ball the kicker chooses the corner
  double reads_at = 0.025;  // m: a keeper this far towards the run-up's corner reads the run-up
  double margin = 0.05;     // m, from the post to the ball's path
  double speed = 1.8;       // m/s
};

// Kicks the penalties that a team was given. Call stand() in place(), and drive() while
// must_take_kick() is true, that is, while the ball lies where it was put.
class PenaltyTaker {
 public:
  explicit PenaltyTaker(const PenaltyHabits& habits = {}) : habits_(habits) {}

  // Returns the pose of the kicker. `y_bias` is as in open_corner(); a random value hides the
  // corner of the run-up.
  mirocup_pose stand(const Setup& setup, const Observation& now, double y_bias) {
    aim_ = open_corner(setup, now, habits_.margin, y_bias);
    return run_up(ball(now), aim_, habits_.run_up);
  }

  // Returns the wheel speeds of the kicker. `robot` is the kicker's state at its next command.
  Wheels drive(const Setup& setup, const Observation& now, const Robot& robot) {
    if (length(ball(now) - position(robot)) > habits_.turn_from) {
      is_decided_ = false;
      return shoot(setup, robot, ball(now), aim_, habits_.speed);
    }
    const double side = aim_.y < 0.0 ? -1.0 : 1.0;
    if (!is_decided_ && side * keeper_y(now) > habits_.reads_at) aim_.y = -aim_.y;
    is_decided_ = true;
    const Point to = aim_ - ball(now);
    const double error = wrapped(math::atan2(to.y, to.x) - robot.heading);
    return wheels_turning_first(setup, habits_.speed, turn_for(setup, robot.turn, error));
  }

 private:
  // Returns the y, m, of the opponents' keeper a moment later.
  static double keeper_y(const Observation& now) {
    int keeper = 0;
    for (int j = 1; j < now.robots; ++j) {
      if (now.opponent[j].x > now.opponent[keeper].x) keeper = j;
    }
    return now.opponent[keeper].y + 0.05 * now.opponent[keeper].vy;
  }

  PenaltyHabits habits_;
  Point aim_;  // m
  bool is_decided_ = false;
};

}  // namespace mirocup::strategy
