// SPDX-License-Identifier: MIT
#include "mirocup/skills/keeper.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

void put_home(SkillField& field) {
  field.put_robot({-field.setup().half_length + 0.05, 0.0}, pi / 2.0);
}

// Plays some ticks; returns whether the ball stayed out of the goal.
bool keeps(SkillField& field, int ticks) {
  for (int tick = 0; tick < ticks; ++tick) {
    field.tick(guard_goal(field.setup(), field.observation(), field.robot()));
    if (field.ball().x < -field.setup().half_length) return false;
  }
  return true;
}

// Catches a keeper that goes where the ball is and not where it will be, and one that loses the
// goal after its parry.
TEST(Keeper, SavesShotsFromTheMiddleOfTheField) {
  int saves = 0;
  int shots = 0;
  for (int from = -3; from <= 3; ++from) {
    for (int to = -3; to <= 3; ++to) {
      SkillField field;
      put_home(field);
      const Point start{-0.1, 0.12 * from};
      const Point aim{-field.setup().half_length, 0.05 * to};
      field.put_ball(start, 1.5 * unit(aim - start));
      ++shots;
      if (keeps(field, 60)) ++saves;
    }
  }
  EXPECT_GE(saves, 0.9 * shots) << saves << " of " << shots;
}

// Catches a keeper that does not look at the walls.
TEST(Keeper, SavesAShotOverTheWall) {
  SkillField field;
  put_home(field);
  field.put_ball({-0.1, 0.45}, {-1.1, 0.6});
  EXPECT_TRUE(keeps(field, 60));
}

// Catches a clearance across the own goal, a keeper that leaves the ball lying, which is a penalty
// after ten seconds, and an own goal.
TEST(Keeper, ClearsABallThatLiesInItsArea) {
  for (const Point lies : {Point{-0.63, 0.0}, Point{-0.63, 0.12}, Point{-0.64, -0.2},
                           Point{-0.66, 0.28}, Point{-0.7, -0.3}}) {
    SkillField field;
    put_home(field);
    field.put_ball(lies);
    ASSERT_TRUE(keeps(field, 120)) << lies.x << ", " << lies.y;
    const Point ball = field.ball();
    EXPECT_TRUE(ball.x > -0.6 || std::abs(ball.y) > 0.35) << ball.x << ", " << ball.y;
  }
}

}  // namespace
}  // namespace mirocup::strategy
