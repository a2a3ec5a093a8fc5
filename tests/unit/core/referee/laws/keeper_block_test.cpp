// SPDX-License-Identifier: MIT
//
// Catches a block that is called too early, one with the ball near, and one of a keeper that waits.
#include "core/referee/laws/keeper_block.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

using test_support::empty_situation;

class KeeperBlock : public test_support::LawTest {
 protected:
  // The left robot 0 stands in front of the right keeper, which is commanded at this velocity.
  int block(double keeper_commanded, const Vec2& ball) {
    Situation s = empty_situation(pitch_.field, ball);
    s.robots[index_of(End::right)][0] = {{0.70, 0.0}, Heading{}};
    s.robots[index_of(End::left)][0] = {{0.62, 0.0}, Heading{}};
    s.commanded[index_of(End::right)][0] = {keeper_commanded, 0.0};
    occupancy_.keeper[index_of(at(End::right))] = RobotId{at(End::right), 0};
    const auto judge = [&](const Situation& turned) {
      return judge_keeper_block(pitch_.pitch(), turned, occupancy_, memory_);
    };
    return ticks_until_called(s, judge, &called_);
  }

  Occupancy occupancy_;
  KeeperBlockMemory memory_;
  std::optional<Decision> called_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperBlock, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperBlock, CostsAGoalKickAfterASecond) {
  EXPECT_EQ(block(-0.3, {0.3, 0.5}), 31) << "0.99 s after the first";
  EXPECT_EQ(called_->verdict, Verdict::GOAL_KICK);
  EXPECT_EQ(called_->team, at(End::left));
  EXPECT_EQ(called_->taker, at(End::right));
}

TEST_P(KeeperBlock, IsNoneWithTheBallNear) {
  EXPECT_EQ(block(-0.3, {0.5, 0.1}), 0);
}

TEST_P(KeeperBlock, IsNoneWhileTheKeeperDoesNotWantToPass) {
  EXPECT_EQ(block(0.0, {0.3, 0.5}), 0);
}

TEST_P(KeeperBlock, IsNoneWithTheBallInTheOtherHalf) {
  EXPECT_EQ(block(-0.3, {-0.3, 0.5}), 0);
}

}  // namespace
}  // namespace mirocup::referee
