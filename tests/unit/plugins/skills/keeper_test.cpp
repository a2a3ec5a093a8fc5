// SPDX-License-Identifier: MIT
//
// Both keepers: guard_goal() and hold_goal().
#include "mirocup/skills/keeper.hpp"

#include "mirocup/skills/hold_goal.hpp"
#include "tests/support/skill_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::strategy {
namespace {

using test_support::SkillField;

struct Keeper {
  const char* name;
  double line;                   // where it stands, m before the goal line
  void (*tick)(SkillField&);     // plays a tick
  double from, speed, far_post;  // the shots that it has to save: m, m/s, m
  double clears;                 // so far from the middle, m
};

void guard_for_a_tick(SkillField& field) {
  field.tick(guard_goal(field.setup(), field.observation(), field.robot()));
}

void hold_for_a_tick(SkillField& field) {
  const Observation now = field.observation();
  const BallPath path(field.setup(), moving_ball(now));
  const Robot soon = when_commanded(field.setup(), now.own[0], field.asked());
  field.tick_later(hold_goal(field.setup(), now, path, soon));
}

const Keeper guard{"guard_goal", 0.05, guard_for_a_tick, -0.1, 1.5, 0.15, 0.3};
const Keeper holder{"hold_goal", GoalHolding{}.line, hold_for_a_tick, -0.3, 2.0, 0.165, 0.2};

// Returns whether the ball stays out of the goal for some ticks.
bool keeps(const Keeper& keeper, Point ball, Point velocity, int ticks, SkillField& field) {
  field.put_robot({-field.setup().half_length + keeper.line, 0.0}, pi / 2.0);
  field.put_ball(ball, velocity);
  for (int tick = 0; tick < ticks; ++tick) {
    keeper.tick(field);
    if (field.ball().x < -field.setup().half_length) return false;
  }
  return true;
}

// Catches a keeper that is late, one that goes where the ball is and not where it will be, and one
// that loses the goal after its parry.
TEST(Keepers, SaveShots) {
  for (const Keeper& keeper : {guard, holder}) {
    int saves = 0;
    for (int shot = 0; shot < 49; ++shot) {
      SkillField field;
      const Point start{keeper.from, 0.12 * (shot / 7 - 3)};
      const Point aim{-field.setup().half_length, keeper.far_post * (shot % 7 - 3) / 3.0};
      if (keeps(keeper, start, keeper.speed * unit(aim - start), 60, field)) ++saves;
    }
    EXPECT_GE(saves, 0.9 * 49) << keeper.name;
  }
}

// Catches a keeper that does not look at the walls.
TEST(Keepers, SaveAShotOverTheWall) {
  SkillField field;
  EXPECT_TRUE(keeps(guard, {-0.1, 0.45}, {-1.1, 0.6}, 60, field));
}

// Catches a keeper that stands before its line: a ball that comes along the end wall meets the
// corner of its face, turns it aside, and rolls in. Half of all goals used to fall like that.
TEST(Keepers, LetNothingInAlongTheEndWall) {
  for (const double side : {-1.0, 1.0}) {
    for (const double speed : {0.3, 0.8, 1.5}) {
      SkillField field;
      const double wall = -field.setup().half_length + field.setup().ball_radius + 0.001;
      EXPECT_TRUE(keeps(holder, {wall, side * 0.45}, {0.0, -side * speed}, 90, field))
          << side << " " << speed;
    }
  }
}

// Catches a clearance across the own goal, a keeper that leaves the ball lying, which is a penalty
// after ten seconds, and an own goal.
TEST(Keepers, ClearABallThatLiesInTheirArea) {
  for (const Keeper& keeper : {guard, holder}) {
    for (const Point lies : {Point{-0.63, 0.0}, Point{-0.63, 0.12}, Point{-0.64, -0.2},
                             Point{-0.66, 0.28}, Point{-0.7, -0.3}}) {
      if (std::abs(lies.y) > keeper.clears) continue;
      SkillField field;
      ASSERT_TRUE(keeps(keeper, lies, {}, 120, field)) << keeper.name << lies.x << ", " << lies.y;
      const Point ball = field.ball();
      EXPECT_TRUE(ball.x > -0.6 || std::abs(ball.y) > 0.35)
          << keeper.name << " " << ball.x << ", " << ball.y;
    }
  }
}

}  // namespace
}  // namespace mirocup::strategy
