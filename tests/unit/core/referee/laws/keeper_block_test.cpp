// SPDX-License-Identifier: MIT
//
// Catches a block that is called too early, one with the ball near, and one of a keeper that waits.
#include "core/referee/laws/keeper_block.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class KeeperBlock : public test_support::LawTest {
 protected:
  // The left robot 0 stands in front of the right keeper, which is commanded at this velocity.
  int block(double keeper_commanded, const Vec2& ball) {
    TickFacts s = with_ball(ball);
    s.robots[index_of(End::right)][0] = {{0.70, 0.0}, Heading{}};
    s.robots[index_of(End::left)][0] = {{0.62, 0.0}, Heading{}};
    s.commanded[index_of(End::right)][0] = {keeper_commanded, 0.0};
    set_right_keeper();
    return ticks_until_called(s, [&](const TickFacts& turned) {
      return judge_keeper_block(pitch_.pitch(), turned, occupancy_, memory_);
    });
  }

  KeeperBlockMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperBlock, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperBlock, CostsAGoalKickAfterASecond) {
  EXPECT_EQ(block(-0.3, {0.3, 0.5}), 31) << "0.99 s after the first";
  expect_call(called_, Verdict::GOAL_KICK, End::left, End::right);
}

TEST_P(KeeperBlock, IsNoneUnlessTheKeeperWantsToPassWithTheBallFarInItsHalf) {
  EXPECT_EQ(block(0.0, {0.3, 0.5}), 0) << "it waits";
  EXPECT_EQ(block(-0.3, {0.5, 0.1}), 0) << "the ball is near";
  EXPECT_EQ(block(-0.3, {-0.3, 0.5}), 0) << "the ball is in the other half";
}

}  // namespace
}  // namespace mirocup::referee
