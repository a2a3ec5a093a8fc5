// SPDX-License-Identifier: MIT
//
// Catches a shove in the allowed direction that is called, pressing that is called too early, and
// the law where it is off.
#include "core/referee/laws/wall_push.hpp"

#include "core/referee/touches.hpp"
#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class WallPush : public test_support::LawTest {
 protected:
  WallPush() { pitch_.rules.wall_push = true; }

  // The ball at the right end wall, above the goal, where it moved by `step` along the wall.
  TickFacts at_wall(double step) const {
    TickFacts s = with_ball({0.70, 0.40});
    s.ball_before = {0.70, 0.40 - step};
    return s;
  }

  // A robot of `team` moves the ball along the wall with a team-mate behind it.
  std::optional<Decision> shove(End team, double step) {
    TickFacts s = at_wall(step);
    s.robots[index_of(team)][0] = {{0.64, 0.40}, Heading{}};
    s.touched_ball[index_of(team)].set(0);
    set_touch(s, {team, 0}, {team, 1});
    return judge_wall_push(pitch_.pitch(), seen(s), memory_);
  }

  WallPushMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, WallPush, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(WallPush, ByADefenderAwayFromTheGoalGivesAFreeBall) {
  EXPECT_FALSE(shove(End::right, -0.01));
  const auto called = shove(End::right, 0.01);
  expect_call(called, Verdict::FREE_BALL, End::right);
  EXPECT_EQ(called->spot, attack_sign(GetParam()) * Vec2(0.375, 0.40));
  pitch_.rules.wall_push = false;
  EXPECT_FALSE(shove(End::right, 0.01)) << "off";
}

TEST_P(WallPush, ByAnAttackerTowardsTheGoalGivesAFreeBallInTheOtherHalf) {
  EXPECT_FALSE(shove(End::left, 0.01));
  const auto called = shove(End::left, -0.01);
  expect_call(called, Verdict::FREE_BALL, End::left);
  EXPECT_EQ(called->spot, attack_sign(GetParam()) * Vec2(-0.375, 0.40));
}

TEST_P(WallPush, ByBothTeamsIsCalledAfterATime) {
  TickFacts s = at_wall(0.0);
  s.robots[index_of(End::left)][0] = {{0.64, 0.40}, Heading{}};
  s.robots[index_of(End::right)][0] = {{0.70, 0.46}, Heading{}};
  const auto judge = [&](const TickFacts& turned) {
    return judge_wall_push(pitch_.pitch(), turned, memory_);
  };
  EXPECT_EQ(ticks_until_called(s, judge), 26) << "0.825 s after the first";
  EXPECT_FALSE(called_->team) << "neither is to blame";
}

}  // namespace
}  // namespace mirocup::referee
