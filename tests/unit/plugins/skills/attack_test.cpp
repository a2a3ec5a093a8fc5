// SPDX-License-Identifier: MIT
#include "mirocup/skills/attack.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Catches a robot that pushes the ball the wrong way when it comes from before it or beside it, and
// one that circles round the ball.
TEST(Attack, ScoresFromEachSideOfTheBall) {
  int goals = 0;
  for (int k = 0; k < 8; ++k) {
    SkillField field;
    const Point lies{0.2, 0.05};
    const double angle = k * pi / 4.0;
    field.put_ball(lies);
    field.put_robot(lies + 0.25 * Point{std::cos(angle), std::sin(angle)}, 0.5 * k);
    for (int tick = 0; tick < 300 && field.ball().x < field.setup().half_length; ++tick) {
      const Point aim{field.setup().half_length, 0.0};
      field.tick_later(attack_ball(field.setup(), field.observation(), 0, aim));
    }
    if (field.ball().x >= field.setup().half_length) ++goals;
  }
  EXPECT_GE(goals, 7);
}

// Catches supporters on top of each other, before the ball, or in their goal area.
TEST(Attack, SupportersStandApartBehindTheBall) {
  const SkillField field(RobotLeague::middle);
  Observation now = field.observation();
  now.ball_x = 0.3;
  now.ball_y = 0.2;
  for (int one = 0; one < 3; ++one) {
    const Point place = supporting_place(field.setup(), now, one + 1, one);
    EXPECT_LT(place.x, now.ball_x - 0.2);
    for (int other = 0; other < one; ++other) {
      const Point beside = supporting_place(field.setup(), now, other + 1, other);
      EXPECT_GT(length(place - beside), 0.2) << one << " and " << other;
    }
  }
}

}  // namespace
}  // namespace mirocup::strategy
