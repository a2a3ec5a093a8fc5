// SPDX-License-Identifier: MIT
//
// Sheet "driving": each robot has a place to go to. Write drive(), and better ways to the ball.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    // Robot 0 stands in the middle of its goal.
    command.wheels[0] = drive(now.own[0], {-0.7, 0.0});
    // Robot 1 lines up behind the ball, on the line to the middle of the opponents' goal.
    const Point along = unit(Point{setup().half_length, 0.0} - ball(now));
    command.wheels[1] = drive(now.own[1], ball(now) - 0.08 * along);
    // Robot 2 touches the ball as soon as it can.
    command.wheels[2] = drive(now.own[2], ball(now));
  }

 private:
  // Drives on and on at 0.4 m/s, and turns towards the target.
  Wheels drive(const Robot& robot, Point target) const {
    const Point to = target - position(robot);
    const double error = wrapped(math::atan2(to.y, to.x) - robot.heading);  // rad
    const double forward = 0.4;                                             // m/s
    const double turn = 4.0 * error;                                        // rad/s
    const double side = turn * setup().wheel_distance / 2.0;
    return {(forward - side) / setup().wheel_radius, (forward + side) / setup().wheel_radius};
  }
};

MIROCUP_EXPORT_TEAM(Mine, "mine")
