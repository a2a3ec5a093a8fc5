// SPDX-License-Identifier: MIT
//
// Catches a keeper that may keep the ball, and a contested ball that costs a penalty.
#include "core/referee/laws/keeper_hold.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

using test_support::empty_situation;

class KeeperHold : public test_support::LawTest {
 protected:
  int hold(const Vec2& ball, const Vec2& opponent) {
    Situation s = empty_situation(pitch_.field, ball);
    s.robots[index_of(End::right)][2].position = opponent;
    const auto judge = [&](const Situation& turned) {
      return judge_keeper_hold(pitch_.pitch(), turned, memory_);
    };
    return ticks_until_called(s, judge, &called_);
  }

  KeeperHoldMemory memory_;
  std::optional<Decision> called_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperHold, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperHold, UncontestedForTenSecondsCostsAPenalty) {
  EXPECT_EQ(hold({-0.67, 0.0}, {0.3, 0.0}), 304) << "9.999 s after the first";
  EXPECT_EQ(called_->verdict, Verdict::PENALTY_KICK);
  EXPECT_EQ(called_->team, at(End::left));
  EXPECT_EQ(called_->taker, at(End::right));
}

TEST_P(KeeperHold, IsNoneWhileTheBallIsContested) {
  EXPECT_EQ(hold({-0.67, 0.0}, {-0.60, 0.0}), 0);
}

TEST_P(KeeperHold, IsNoneOutsideOfTheGoalArea) {
  EXPECT_EQ(hold({-0.50, 0.0}, {0.3, 0.0}), 0);
}

}  // namespace
}  // namespace mirocup::referee
