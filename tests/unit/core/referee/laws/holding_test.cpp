// SPDX-License-Identifier: MIT
//
// Catches a ball that is hidden too deep and not called, one just deep enough that is, and a keeper
// that is called.
#include "core/referee/laws/holding.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class Holding : public test_support::LawTest {
 protected:
  // Judges while the left robot 1 has the ball this deep inside its front, m.
  int hold(double depth) {
    TickFacts s = with_ball({0.0375 + 0.02135 - depth, 0.0});
    s.robots[index_of(End::left)][1] = {{0.0, 0.0}, Heading{}};
    s.touched_ball[index_of(End::left)].set(1);
    return ticks_until_called(s, [&](const TickFacts& turned) {
      return judge_holding(pitch_.pitch(), turned, occupancy_, memory_);
    });
  }

  HoldingMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Holding, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Holding, TheBallTooDeepForAMomentGivesAFreeBall) {
  EXPECT_EQ(hold(0.0130), 7) << "0.198 s after the first";
  expect_call(called_, Verdict::FREE_BALL, End::left);
  EXPECT_EQ(called_->robots[index_of(at(End::left))].to_ulong(), 0b010u);
}

TEST_P(Holding, IsAllowedIfTheBallIsLessDeepAndForTheKeeper) {
  EXPECT_EQ(hold(0.0126), 0);
  occupancy_.keeper[index_of(at(End::left))] = RobotId{at(End::left), 1};
  EXPECT_EQ(hold(0.0130), 0);
}

}  // namespace
}  // namespace mirocup::referee
