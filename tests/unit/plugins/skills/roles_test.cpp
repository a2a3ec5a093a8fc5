// SPDX-License-Identifier: MIT
#include "mirocup/skills/roles.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

// Catches roles that change in every tick where two robots are equally far, and roles that never
// change.
TEST(CheapestRobot, KeepsItsRoleUntilAnotherOneIsClearlyBetter) {
  const SkillField field;
  Observation now = field.observation();
  now.robots = 3;
  const auto choose = [&](double of_1, double of_2, int last) {
    return cheapest_robot(now, 1, last, 0.2, [&](int i) { return i == 1 ? of_1 : of_2; });
  };
  EXPECT_EQ(choose(1.0, 0.9, 1), 1);
  EXPECT_EQ(choose(1.0, 0.9, 2), 2);
  EXPECT_EQ(choose(1.0, 0.7, 1), 2);
}

// Catches a cost that forgets the way round the ball.
TEST(TimeBehind, CostsMoreBeforeTheBall) {
  const SkillField field;
  Observation now = field.observation();
  now.robots = 2;
  now.own[0] = {.x = -0.3, .y = 0.0, .heading = 0.0, .vx = 0.0, .vy = 0.0, .turn = 0.0};
  now.own[1] = {.x = 0.3, .y = 0.0, .heading = 0.0, .vx = 0.0, .vy = 0.0, .turn = 0.0};
  now.ball_x = 0.0;
  now.ball_vx = 0.0;
  EXPECT_GT(time_behind(field.setup(), now, 1), time_behind(field.setup(), now, 0) + 0.3);
}

// Catches two robots at one place, and robots that change places because of a centimetre.
TEST(AssignPlaces, GivesEachPlaceToARobotOfItsOwn) {
  const SkillField field;
  Observation now = field.observation();
  now.robots = 4;
  for (int i = 1; i < 4; ++i) now.own[i] = now.own[0];
  now.own[1].x = -0.20;
  now.own[2].x = -0.21;
  now.own[3].x = 0.50;
  const std::array<Point, 3> places{{{-0.2, now.own[0].y}, {-0.2, now.own[0].y}, {0.0, 0.0}}};
  const std::array<int, 3> free{1, 2, 3};
  const Assignment fresh = assign_places(now, places, free, {});
  EXPECT_EQ(fresh[0], 1);
  EXPECT_EQ(fresh[1], 2);
  EXPECT_EQ(fresh[2], 3);
  const Assignment kept = assign_places(now, places, free, {2, 1, 3});
  EXPECT_EQ(kept[0], 2);
  EXPECT_EQ(kept[1], 1);
}

}  // namespace
}  // namespace mirocup::strategy
