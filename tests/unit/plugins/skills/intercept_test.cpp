// SPDX-License-Identifier: MIT
#include "mirocup/skills/intercept.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

Observation ball_at(const SkillField& field, Point at, Point velocity) {
  Observation now = field.observation();
  now.ball_x = at.x;
  now.ball_y = at.y;
  now.ball_vx = velocity.x;
  now.ball_vy = velocity.y;
  return now;
}

// Catches a prediction that misses the root: a robot then runs after the ball, which it should
// meet.
TEST(Intercept, IsTheEarliestPointThatTheRobotReaches) {
  const SkillField field;
  const double pace = 1.2;
  for (const Point velocity :
       {Point{0.0, 0.0}, Point{0.6, 0.2}, Point{-1.5, 0.9}, Point{2.0, 0.0}}) {
    const Observation now = ball_at(field, {0.2, 0.1}, velocity);
    Robot robot{};
    robot.x = -0.5;
    const Interception meet = intercept(field.setup(), now, robot, pace);
    ASSERT_TRUE(meet.is_reached);
    EXPECT_NEAR(length(meet.ball.at - position(robot)) / pace, meet.seconds, 0.01);
    for (double t = 0.0; t < meet.seconds - 0.05; t += 0.01) {
      const Point then = rolled(field.setup(), moving_ball(now), t).at;
      EXPECT_GT(length(then - position(robot)) / pace, t) << t;
    }
  }
}

// Catches a path without walls: a ball that rebounds from the wall behind the robot is met on its
// way back, not outside the field.
TEST(Intercept, KnowsTheWalls) {
  const SkillField field;
  const Observation now = ball_at(field, {0.5, 0.4}, {2.0, 0.0});
  Robot robot{};
  robot.x = -0.3;
  robot.y = 0.4;
  const Interception meet = intercept(field.setup(), now, robot);
  ASSERT_TRUE(meet.is_reached);
  EXPECT_LT(meet.ball.at.x, field.setup().half_length);
  EXPECT_LT(meet.ball.velocity.x, 0.0);
}

// Catches a search that calls a ball reached which is too fast for the robot.
TEST(Intercept, SaysThatTheBallIsTooFast) {
  const SkillField field(RobotLeague::large);
  const Observation now = ball_at(field, {0.0, 0.0}, {3.0, 0.0});
  Robot robot{};
  robot.x = -1.0;
  EXPECT_FALSE(intercept(field.setup(), now, robot, 1.2, 0.5).is_reached);
}

}  // namespace
}  // namespace mirocup::strategy
