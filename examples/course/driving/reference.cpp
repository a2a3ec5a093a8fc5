// SPDX-License-Identifier: MIT
//
// Sheet "driving": the reference, 100 on the scale of the sheet.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Reference : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    command.wheels[0] = drive(now.own[0], {-0.7, 0.0}, 0.0);
    command.wheels[1] = line_up(now, now.own[1]);
    command.wheels[2] = hurry(now, now.own[2]);
  }

 private:
  // Comes to the ball along the line of the shot: the nearer to the ball, the nearer to the line.
  Wheels line_up(const Observation& now, const Robot& robot) const {
    const Point along = unit(Point{setup().half_length, 0.0} - ball(now));
    const Point from_ball = position(robot) - ball(now);
    const double behind = -dot(from_ball, along);                                  // m
    const double aside = std::abs(from_ball.x * along.y - from_ball.y * along.x);  // m
    if (behind < 0.7 * aside) return drive(robot, ball(now) - 0.16 * along, 0.3);
    if (behind < 0.1 && aside < 0.03) return drive(robot, ball(now) + 0.2 * along, 1.0);
    return drive(robot, ball(now) - math::max(0.06, 0.75 * behind) * along, 0.5);
  }

  // Drives to the ball at full speed, and past the side of an opponent that stands on the way.
  Wheels hurry(const Observation& now, const Robot& robot) const {
    constexpr double berth = 0.11;  // m, between the middles of two robots
    const Point along = unit(ball(now) - position(robot));
    const Point left{-along.y, along.x};
    Point target = ball(now);
    double free = length(ball(now) - position(robot));  // m, of the way
    for (int j = 0; j < now.robots; ++j) {
      const Point other = position(now.opponent[j]) - position(robot);
      const double ahead = dot(other, along);
      const double aside = dot(other, left);
      if (ahead < 0.02 || ahead > free || std::abs(aside) > berth) continue;
      free = ahead;
      target = position(now.opponent[j]) + (aside > 0.0 ? -berth : berth) * left;
    }
    return drive(robot, target, 2.0);
  }

  // Drives to a target and arrives there at `arrival` m/s, forwards or backwards, whichever needs
  // the smaller turn.
  Wheels drive(const Robot& robot, Point target, double arrival) const {
    const Point to = target - position(robot);
    double error = wrapped(math::atan2(to.y, to.x) - robot.heading);
    double direction = 1.0;
    if (std::abs(error) > pi / 2.0) {
      error = wrapped(error + pi);
      direction = -1.0;
    }
    // A command is driven one tick later, and the motors lag: the robot brakes for the place where
    // it will be then.
    const double delay = setup().control_period + setup().motor_time_constant;
    const double rolls_on = delay * dot({robot.vx, robot.vy}, unit(to));  // m
    const double wanted = arrival + 10.0 * (length(to) - rolls_on);
    double forward = math::clamp(wanted, -2.0, 2.0) * math::cos(error);
    // Near the target its direction changes too fast to follow.
    const double turn = length(to) < 0.02 && arrival == 0.0 ? 0.0 : 10.0 * error;
    // Sliding wheels do not steer.
    const double steady = 0.8 * setup().grip * 9.81;  // m/s^2
    if (std::abs(forward * turn) > steady)
      forward = std::copysign(steady / std::abs(turn), forward);
    return wheels_for(setup(), direction * forward, turn);
  }
};

MIROCUP_EXPORT_TEAM(Reference, "reference")
