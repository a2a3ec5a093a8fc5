// SPDX-License-Identifier: MIT
//
// Catches a ball that is hidden too deep and not called, one just deep enough that is, and a keeper
// that is called.
#include "core/referee/laws/holding.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

using test_support::empty_situation;

class Holding : public test_support::LawTest {
 protected:
  // Judges while the left robot 1 has the ball this deep inside its front, m.
  int hold(double depth) {
    Situation s = empty_situation(pitch_.field, {0.0375 + 0.02135 - depth, 0.0});
    s.robots[index_of(End::left)][1] = {{0.0, 0.0}, Heading{}};
    s.touched_ball[index_of(End::left)].set(1);
    const auto judge = [&](const Situation& turned) {
      return judge_holding(pitch_.pitch(), turned, occupancy_, memory_);
    };
    return ticks_until_called(s, judge, &called_);
  }

  Occupancy occupancy_;
  HoldingMemory memory_;
  std::optional<Decision> called_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Holding, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Holding, TheBallTooDeepForAMomentGivesAFreeBall) {
  EXPECT_EQ(hold(0.0130), 7) << "0.198 s after the first";
  EXPECT_EQ(called_->verdict, Verdict::FREE_BALL);
  EXPECT_EQ(called_->team, at(End::left));
  EXPECT_EQ(called_->robots[index_of(at(End::left))].to_ulong(), 0b010u);
}

TEST_P(Holding, TheBallLessDeepIsAllowed) {
  EXPECT_EQ(hold(0.0126), 0);
}

TEST_P(Holding, IsAllowedForTheKeeper) {
  occupancy_.keeper[index_of(at(End::left))] = RobotId{at(End::left), 1};
  EXPECT_EQ(hold(0.0130), 0);
}

}  // namespace
}  // namespace mirocup::referee
