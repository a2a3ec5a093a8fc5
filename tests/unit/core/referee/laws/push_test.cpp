// SPDX-License-Identifier: MIT
//
// Catches a push that is called too early or against the wrong side, and a duel that is called at
// all.
#include "core/referee/laws/push.hpp"

#include "core/referee/touches.hpp"
#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class Pushing : public test_support::LawTest {
 protected:
  // The left robot 0 pushes the right robot 1 along x, 10 mm a tick. Returns the call, or nothing
  // after 0.2 m.
  std::optional<Decision> push(const Vec2& ball, double resistance = 0.0, bool plays_ball = false) {
    for (ticks_ = 0; ticks_ <= 20; ++ticks_) {
      TickFacts s = with_ball(ball);
      const double x = -0.1 + 0.01 * ticks_;
      s.robots[index_of(End::left)][0] = {{x, 0.0}, Heading{}};
      s.robots[index_of(End::right)][1] = {{x + 0.076, 0.0}, Heading{}};
      s.commanded[index_of(End::left)][0] = {0.3, 0.0};
      s.commanded[index_of(End::right)][1] = {-resistance, 0.0};
      s.touched_ball[index_of(End::left)][0] = plays_ball;
      s.last_touch = RobotId{End::left, 2};
      set_touch(s, {End::left, 0}, {End::right, 1});
      if (auto called = judge_push(pitch_.pitch(), seen(s), occupancy_, memory_)) return called;
    }
    return std::nullopt;
  }

  PushMemory memory_;
  int ticks_ = 0;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, Pushing, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(Pushing, ByTheDefendingSideCostsAFreeKick) {
  const auto called = push({-0.3, 0.3});
  expect_call(called, Verdict::FREE_KICK, End::left, End::right);
  EXPECT_NEAR(ticks_, 10, 1) << "0.1 m";
  EXPECT_EQ(called->law, Law::push);
  EXPECT_FALSE(push({-0.3, 0.3})) << "within the 2 s after a call";
}

TEST_P(Pushing, ByTheAttackingSideGivesAFreeBallOrAGoalKick) {
  const auto in_field = push({0.3, 0.3});
  expect_call(in_field, Verdict::FREE_BALL, End::left);
  EXPECT_EQ(in_field->law, Law::attacking_push);
  memory_ = {};
  expect_call(push({0.65, 0.1}), Verdict::GOAL_KICK, End::left);
}

TEST_P(Pushing, IsNoneIfTheOpponentDrivesBackOrThePusherPlaysTheBall) {
  EXPECT_FALSE(push({-0.3, 0.3}, 0.3));
  EXPECT_FALSE(push({-0.3, 0.3}, 0.0, true));
}

}  // namespace
}  // namespace mirocup::referee
