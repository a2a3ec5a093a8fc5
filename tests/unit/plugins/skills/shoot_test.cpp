// SPDX-License-Identifier: MIT
#include "mirocup/skills/shoot.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Returns where the ball crosses x = half_length, m; NaN if it does not within a second.
double crossing(SkillField& field, Point spot, Point aim) {
  for (int tick = 0; tick < 30; ++tick) {
    const Point before = field.ball();
    field.tick(shoot(field.setup(), field.robot(), spot, aim));
    const Point after = field.ball();
    const double line = field.setup().half_length;
    if (after.x >= line) {
      return before.y + (line - before.x) / (after.x - before.x) * (after.y - before.y);
    }
  }
  return std::nan("");
}

// Catches a run-up that is put down as a hall puts it down, 4 mm and 3 degrees off, and a shot that
// then misses the goal or its corner.
TEST(Shoot, MeetsTheCornerFromARunUpThatIsALittleOff) {
  const Point spot{0.375, 0.0};
  for (const double corner : {-0.15, 0.15}) {
    for (const double off : {-1.0, 0.0, 1.0}) {
      SkillField field;
      const Point aim{field.setup().half_length, corner};
      const mirocup_pose start = run_up(spot, aim);
      field.put_ball(spot);
      field.put_robot({start.x, start.y + 0.004 * off}, start.heading + 0.05 * off);
      EXPECT_NEAR(crossing(field, spot, aim), corner, 0.025) << off;
      EXPECT_GT(length(field.ball_velocity()), 1.8) << off;
    }
  }
}

// Catches a robot that comes back to its line by an ever wider swing, or leaves it backwards.
TEST(FollowLine, ComesBackToTheLineEitherWayRound) {
  for (const double heading : {0.0, pi}) {
    SkillField field;
    field.put_ball({0.0, 0.6});
    field.put_robot({-0.6, 0.08}, heading);
    for (int tick = 0; tick < 25; ++tick) {
      field.tick(follow_line(field.setup(), field.robot(), {0.0, 0.0}, 0.0, 1.2));
    }
    EXPECT_NEAR(field.robot().y, 0.0, 0.008);
    EXPECT_GT(field.robot().vx, 1.1);
  }
}

// Catches an aim at the very corner that the keeper covers.
TEST(OpenCorner, IsOnTheOtherSideOfTheKeeper) {
  const SkillField field;
  Observation now = field.observation();
  now.opponent[0].y = 0.06;
  EXPECT_LT(open_corner(field.setup(), now).y, -0.1);
  now.opponent[0].y = -0.06;
  EXPECT_GT(open_corner(field.setup(), now).y, 0.1);
}

}  // namespace
}  // namespace mirocup::strategy
