// SPDX-License-Identifier: MIT
//
// Teams that break the laws on purpose.
#pragma once

#include "tests/support/controllers.hpp"

namespace mirocup::test_support {

// Returns wheel speeds that turn towards a point and drive at it, front or back first.
inline simulator::WheelSpeeds towards(const match::ObservedRobot& robot, const Vec2& point,
                                      double speed) {
  const Vec2 seen = Heading::from_angle(robot.heading).to_body(point - robot.position);
  const double ahead = seen.x() < 0.0 ? -1.0 : 1.0;
  const double turn = 20.0 * atan2(ahead * seen.y(), ahead * seen.x());
  if (seen.squaredNorm() < 1e-4) return {};
  return {ahead * speed - turn, ahead * speed + turn};
}

// A team whose robots drive to the places that `where(observation, robot)` returns.
template <class Where>
Scripted team_of(Where where, double speed = 40.0) {
  return Scripted([where, speed](const match::Observation& o) -> match::Answer {
    match::Command command;
    for (int i = 0; i < o.robots; ++i) {
      command.wheels[i] = towards(o.own[i], where(o, i), speed);
    }
    return command;
  });
}

// All robots drive into their own goal area and park there.
inline Scripted goal_parkers(double goal_line) {
  return team_of([goal_line](const match::Observation&, int i) {
    return Vec2{-goal_line + 0.06, 0.09 * (i - 1)};
  });
}

// All robots drive into the other goal area, at the keeper.
inline Scripted raiders(double goal_line) {
  return team_of([goal_line](const match::Observation& o, int i) {
    return i == 0 ? o.ball : Vec2{goal_line - 0.06, 0.09 * (i - 1)};
  });
}

// Every robot drives at the opponent with the same index, never at the ball.
inline Scripted man_hunters() {
  return team_of([](const match::Observation& o, int i) { return o.opponent[i].position; });
}

}  // namespace mirocup::test_support
