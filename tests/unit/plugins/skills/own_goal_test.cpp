// SPDX-License-Identifier: MIT
#include "mirocup/strategy.hpp"
#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// A ball passes before the own goal, and a robot stands there at a slant. Returns whether the ball
// is turned in, where the robot is helped or not.
bool is_turned_in(bool is_helped, double heading) {
  SkillField field;
  field.put_robot({-0.52, 0.08}, heading);
  field.put_ball({-0.42, 0.52}, {-0.4, -1.4});
  for (int tick = 0; tick < 40; ++tick) {
    Observation now = field.observation();
    now.robots = 2;
    now.own[1] = field.robot();
    now.own[0].x = -0.7;
    Command command{};
    if (is_helped) avoid_own_goals(field.setup(), now, command);
    field.tick(command.wheels[1]);
    if (field.ball().x < -field.setup().half_length) return true;
  }
  return false;
}

// Catches a defender that waits at a slant, from which a ball that would pass rolls into its goal.
TEST(OwnGoals, ASlantingRobotTurnsSquareInTime) {
  EXPECT_TRUE(is_turned_in(false, 2.15));
  EXPECT_FALSE(is_turned_in(true, 2.15));
}

// Catches robots that stand in the way of their keeper's clearance.
TEST(OwnGoals, MakeWayLeavesTheMouthOfTheGoalFree) {
  const SkillField field;
  Observation now = field.observation();
  now.ball_x = -0.65;
  for (const double y : {-0.1, 0.0, 0.1}) {
    const Point place = make_way(field.setup(), now, {-0.5, y});
    EXPECT_GE(std::abs(place.y), field.setup().goal_half_width);
  }
  now.ball_x = 0.3;
  EXPECT_EQ(make_way(field.setup(), now, {-0.5, 0.1}).y, 0.1);
}

}  // namespace
}  // namespace mirocup::strategy
