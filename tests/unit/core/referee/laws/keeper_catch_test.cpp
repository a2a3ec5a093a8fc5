// SPDX-License-Identifier: MIT
//
// Catches a catch that goes unseen, one of a ball outside of the goal area, and the wrong team's
// kick.
#include "core/referee/laws/keeper_catch.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

using test_support::empty_situation;

class KeeperCatch : public test_support::LawTest {
 protected:
  // The right keeper has the ball this deep inside its front, m.
  int catch_ball(double depth, double keeper_x = 0.70) {
    Situation s = empty_situation(pitch_.field, {keeper_x - 0.0375 - 0.02135 + depth, 0.2});
    s.robots[index_of(End::right)][0] = {{keeper_x, 0.2}, Heading{}};
    s.touched_ball[index_of(End::right)].set(0);
    occupancy_.keeper[index_of(at(End::right))] = RobotId{at(End::right), 0};
    const auto judge = [&](const Situation& turned) {
      return judge_keeper_catch(pitch_.pitch(), turned, occupancy_, memory_);
    };
    return ticks_until_called(s, judge, &called_);
  }

  Occupancy occupancy_;
  KeeperCatchMemory memory_;
  std::optional<Decision> called_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperCatch, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperCatch, GivesItsTeamAGoalKick) {
  EXPECT_EQ(catch_ball(0.0130), 7);
  EXPECT_EQ(called_->verdict, Verdict::GOAL_KICK);
  EXPECT_EQ(called_->team, at(End::right));
  EXPECT_EQ(called_->taker, at(End::right));
}

TEST_P(KeeperCatch, IsNoneIfTheBallIsLessDeep) {
  EXPECT_EQ(catch_ball(0.0126), 0);
}

TEST_P(KeeperCatch, IsNoneOutsideOfTheGoalArea) {
  EXPECT_EQ(catch_ball(0.0130, 0.62), 0);
}

}  // namespace
}  // namespace mirocup::referee
