// SPDX-License-Identifier: MIT
//
// Catches a keeper that may keep the ball, and a contested ball that costs a penalty.
#include "core/referee/laws/keeper_hold.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class KeeperHold : public test_support::LawTest {
 protected:
  int hold(const Vec2& ball, const Vec2& opponent) {
    TickFacts s = with_ball(ball);
    s.robots[index_of(End::right)][2].position = opponent;
    return ticks_until_called(s, [&](const TickFacts& turned) {
      return judge_keeper_hold(pitch_.pitch(), turned, memory_);
    });
  }

  KeeperHoldMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperHold, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperHold, UncontestedForTenSecondsCostsAPenalty) {
  EXPECT_EQ(hold({-0.67, 0.0}, {0.3, 0.0}), 304) << "9.999 s after the first";
  expect_call(called_, Verdict::PENALTY_KICK, End::left, End::right);
}

// Opponents contest the ball from one and a half sides of a robot on: 0.1125 m.
TEST_P(KeeperHold, IsNoneWhileTheBallIsContestedOrOutsideOfTheGoalArea) {
  EXPECT_EQ(hold({-0.67, 0.0}, {-0.67 + 0.1124, 0.0}), 0);
  EXPECT_EQ(hold({-0.67, 0.0}, {-0.67 + 0.1126, 0.0}), 304);
  EXPECT_EQ(hold({-0.50, 0.0}, {0.3, 0.0}), 0);
}

}  // namespace
}  // namespace mirocup::referee
