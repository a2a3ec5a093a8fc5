// SPDX-License-Identifier: MIT
#include "mirocup/skills/hold_goal.hpp"

#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

void put_keeper(SkillField& field, double y = 0.0) {
  field.put_robot({-field.setup().half_length + GoalHolding{}.line, y}, pi / 2.0);
}

// Plays some ticks with the delay of a match; returns whether the ball stayed out of the goal.
bool holds(SkillField& field, int ticks) {
  Wheels asked{};
  for (int tick = 0; tick < ticks; ++tick) {
    const Observation now = field.observation();
    const BallPath path(field.setup(), moving_ball(now));
    const Robot soon = when_commanded(field.setup(), now.own[0], asked);
    const Wheels next = hold_goal(field.setup(), now, path, soon);
    field.tick(asked);
    asked = next;
    if (field.ball().x < -field.setup().half_length) return false;
  }
  return true;
}

// Catches a keeper that is late: at 2 m/s from 0.45 m before the goal.
TEST(HoldGoal, SavesHardShots) {
  int saves = 0;
  int shots = 0;
  for (int from = -3; from <= 3; ++from) {
    for (int to = -3; to <= 3; ++to) {
      SkillField field;
      put_keeper(field);
      const Point start{-0.3, 0.12 * from};
      const Point aim{-field.setup().half_length, 0.055 * to};
      field.put_ball(start, 2.0 * unit(aim - start));
      ++shots;
      if (holds(field, 60)) ++saves;
    }
  }
  EXPECT_GE(saves, 0.9 * shots) << saves << " of " << shots;
}

// Catches a keeper that stands before its line: a ball that comes along the end wall meets the
// corner of its face, turns it aside, and rolls in. Half of all goals used to fall like that.
TEST(HoldGoal, LetsNothingInAlongTheEndWall) {
  for (const double side : {-1.0, 1.0}) {
    for (const double speed : {0.3, 0.8, 1.5}) {
      SkillField field;
      put_keeper(field);
      const double wall = -field.setup().half_length + field.setup().ball_radius + 0.001;
      field.put_ball({wall, side * 0.45}, {0.0, -side * speed});
      EXPECT_TRUE(holds(field, 90)) << side << " " << speed;
    }
  }
}

// Catches a clearance across the own goal, and a keeper that leaves the ball lying, which is a
// penalty after ten seconds.
TEST(HoldGoal, ClearsABallThatLiesInItsArea) {
  for (const Point lies : {Point{-0.63, 0.0}, Point{-0.63, 0.12}, Point{-0.64, -0.2}}) {
    SkillField field;
    put_keeper(field);
    field.put_ball(lies);
    ASSERT_TRUE(holds(field, 120)) << lies.x << ", " << lies.y;
    const Point ball = field.ball();
    EXPECT_TRUE(ball.x > -0.6 || std::abs(ball.y) > 0.35) << ball.x << ", " << ball.y;
  }
}

}  // namespace
}  // namespace mirocup::strategy
