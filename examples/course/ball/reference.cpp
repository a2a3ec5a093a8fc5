// SPDX-License-Identifier: MIT
//
// Sheet "ball": the reference, 100 on the scale of the sheet.
#include "mirocup/strategy.hpp"

using namespace mirocup::strategy;

class Reference : public Team {
 public:
  using Team::Team;

  void decide(const Observation& now, Command& command) override {
    const Robot& robot = now.own[1];
    const Point meet = meeting(now, robot);
    const Point along = unit(Point{setup().half_length, 0.0} - meet);
    const Point left{-along.y, along.x};
    const Point from_ball = position(robot) - meet;
    const double behind = -dot(from_ball, along);  // m
    const double aside = dot(from_ball, left);     // m
    if (behind > 0.0 && std::abs(aside) < 0.02 + 0.35 * behind) {
      // Near the line of the shot: back to the line, and through the ball.
      const Point through = meet + 0.3 * along - (2.0 * aside) * left;
      command.wheels[1] = drive_to(setup(), robot, through, 2.2, 2.2);
    } else {
      // Round the ball, never nearer than the robot needs to turn.
      const double side = behind > 0.05 ? 0.0 : aside > 0.0 ? 0.11 : -0.11;
      const Point place = inside(setup(), meet - 0.11 * along + side * left);
      command.wheels[1] = drive_to(setup(), robot, place, 0.5, 1.7);
    }
  }

 private:
  // Returns the first place on the way of the ball at which the robot can be as early as the ball.
  Point meeting(const Observation& now, const Robot& robot) const {
    constexpr double pace = 1.2;  // m/s, of the robot on its way
    double t = 0.0;
    while (t < 2.0 && length(ball_at(now, t) - position(robot)) > pace * t) t += 0.033;
    return ball_at(now, t);
  }

  // Returns the place of the ball after t seconds, also if a wall has thrown it back.
  Point ball_at(const Observation& now, double t) const {
    const Point free = ball_after(now, t);
    return {thrown_back(free.x, setup().half_length), thrown_back(free.y, setup().half_width)};
  }

  double thrown_back(double at, double wall) const {
    const double most = wall - setup().ball_radius;
    const double over = math::max(0.0, std::abs(at) - most) * (1.0 + setup().ball_wall_restitution);
    return at > 0.0 ? at - over : at + over;
  }
};

MIROCUP_EXPORT_TEAM(Reference, "reference")
