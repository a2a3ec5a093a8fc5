// SPDX-License-Identifier: MIT
//
// Catches a brush that is called, a hard hit that is not, and a charge through the ball that is.
#include "core/referee/laws/keeper_charge.hpp"

#include "core/referee/touches.hpp"
#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class KeeperCharge : public test_support::LawTest {
 protected:
  // The left robot 0 touches the right keeper, driving at it and coming at these speeds.
  int charge(double commanded, double speed, const Vec2& ball, bool touches_ball = false) {
    TickFacts s = with_ball(ball);
    s.robots[index_of(End::right)][0] = {{0.68, 0.0}, Heading{}};
    s.robots[index_of(End::left)][0] = {{0.60, 0.0}, Heading{}};
    s.commanded[index_of(End::left)][0] = {commanded, 0.0};
    s.velocity[index_of(End::left)][0] = {speed, 0.0};
    s.touched_ball[index_of(End::left)][0] = touches_ball;
    set_touch(s, {End::left, 0}, {End::right, 0});
    set_right_keeper();
    return ticks_until_called(s, [&](const TickFacts& turned) {
      return judge_keeper_charge(pitch_.pitch(), turned, occupancy_, memory_);
    });
  }

  KeeperChargeMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KeeperCharge, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(KeeperCharge, ByDrivingIntoTheKeeperCostsAGoalKick) {
  EXPECT_EQ(charge(0.3, 0.1, {0.5, 0.3}), 4) << "0.099 s after the first";
  expect_call(called_, Verdict::GOAL_KICK, End::left, End::right);
}

TEST_P(KeeperCharge, ByAHardImpactIsCalledAtOnce) {
  EXPECT_EQ(charge(0.0, 0.49, {0.5, 0.3}), 0) << "a brush";
  memory_ = {};
  EXPECT_EQ(charge(0.0, 0.51, {0.5, 0.3}), 1);
}

TEST_P(KeeperCharge, ThroughTheBallIsAllowed) {
  EXPECT_EQ(charge(0.3, 0.6, {0.64, 0.0}, true), 0);
}

}  // namespace
}  // namespace mirocup::referee
