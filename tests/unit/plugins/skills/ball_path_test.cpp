// SPDX-License-Identifier: MIT
#include "mirocup/skills/ball_path.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Catches a wrong braking constant, a wall at the wrong distance, a rebound of the wrong speed
// and a corner that is missing.
TEST(BallPath, IsThatOfTheSimulator) {
  const std::vector<MovingBall> starts{
      {{0.0, 0.0}, {0.8, 0.1}},   {{0.1, 0.2}, {0.5, 1.5}},   {{-0.5, 0.5}, {-0.9, 0.8}},
      {{0.6, -0.3}, {0.3, -1.8}}, {{-0.2, 0.1}, {2.0, 1.1}},  {{0.3, 0.0}, {0.05, 0.02}},
      {{0.5, 0.55}, {1.5, 0.4}},  {{0.0, -0.6}, {1.2, -0.3}},
  };
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle}) {
    for (const MovingBall& start : starts) {
      SkillField field(league);
      field.put_robot({-0.6, -0.5}, 0.0);
      field.put_ball(start.at, start.velocity);
      for (int tick = 0; tick < 90; ++tick) field.tick({});
      const MovingBall there = rolled(field.setup(), start, 90 * field.setup().control_period);
      EXPECT_NEAR(there.at.x, field.ball().x, 1e-6) << start.at.x << " " << start.at.y;
      EXPECT_NEAR(there.at.y, field.ball().y, 1e-6) << start.at.x << " " << start.at.y;
      EXPECT_NEAR(there.velocity.x, field.ball_velocity().x, 2e-3);
      EXPECT_NEAR(there.velocity.y, field.ball_velocity().y, 2e-3);
    }
  }
}

// Catches a path that loses a piece between two walls, or goes on behind a ball that has stopped.
TEST(BallPath, IsThatOfRolledForOneWhoAsksOften) {
  const SkillField field;
  for (const MovingBall& start :
       {MovingBall{{0.1, 0.2}, {0.5, 1.5}}, MovingBall{{-0.2, 0.1}, {2.0, 1.1}},
        MovingBall{{0.3, 0.0}, {0.05, 0.02}}, MovingBall{{0.3, 0.0}, {0.0, 0.0}}}) {
    const BallPath path(field.setup(), start);
    for (double t = 0.0; t < 1.5; t += 0.1) {
      const MovingBall one = rolled(field.setup(), start, t);
      const MovingBall other = path.after(t);
      EXPECT_LT(length(one.at - other.at), 1e-3) << t;
      EXPECT_LT(length(one.velocity - other.velocity), 2e-3) << t;
    }
  }
}

// Catches a keeper's line that is crossed a tick late, or by a ball that rolls away.
TEST(BallPath, CrossesALine) {
  const SkillField field;
  const Crossing crossing = time_at_x(field.setup(), {{0.0, 0.1}, {-1.0, 0.2}}, -0.6);
  ASSERT_TRUE(crossing.is_ahead);
  EXPECT_NEAR(crossing.y, 0.1 + 0.2 * 0.6, 1e-3);
  EXPECT_NEAR(crossing.seconds, 0.65, 0.03);
  EXPECT_FALSE(time_at_x(field.setup(), {{0.0, 0.1}, {1.0, 0.2}}, -0.6, 0.5).is_ahead);
}

}  // namespace
}  // namespace mirocup::strategy
