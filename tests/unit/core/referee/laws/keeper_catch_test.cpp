// SPDX-License-Identifier: MIT
//
// Catches a catch that goes unseen, one of a ball outside of the goal area, and the wrong team's
// kick.
#include "core/referee/laws/keeper_catch.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class KeeperCatch : public test_support::LawTest {
 protected:
  // The right keeper has the ball this deep inside its front, m.
  int catch_ball(double depth, double keeper_x = 0.70) {
    TickFacts s = with_ball({keeper_x - 0.0375 - 0.02135 + depth, 0.2});
    s.robots[index_of(End::right)][0] = {{keeper_x, 0.2}, Heading{}};
    s.touched_ball[index_of(End::right)].set(0);
    set_right_keeper();
    return ticks_until_called(s, [&](const TickFacts& turned) {
      return judge_keeper_catch(pitch_.pitch(), turned, occupancy_, memory_);
    });
  }

  KeeperCatchMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperCatch, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperCatch, GivesItsTeamAGoalKick) {
  EXPECT_EQ(catch_ball(0.0130), 7);
  expect_call(called_, Verdict::GOAL_KICK, End::right, End::right);
}

TEST_P(KeeperCatch, IsNoneIfTheBallIsLessDeepOrOutsideOfTheGoalArea) {
  EXPECT_EQ(catch_ball(0.0126), 0);
  EXPECT_EQ(catch_ball(0.0130, 0.62), 0);
}

}  // namespace
}  // namespace mirocup::referee
