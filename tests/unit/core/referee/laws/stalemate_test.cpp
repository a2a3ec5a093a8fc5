// SPDX-License-Identifier: MIT
//
// Catches a count that a shaken ball restarts, one that never restarts, a free ball in the wrong
// quarter, and the wrong law inside a goal area.
#include "core/referee/laws/stalemate.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::referee {
namespace {

class RestingBall : public test_support::LawTest {
 protected:
  // Judges a ball that lies, or shakes, at a place until it is called.
  int wait(const Vec2& ball, double shake = 0.0, std::optional<Vec2> opponent = std::nullopt) {
    TickFacts s = with_ball(ball);
    if (opponent) s.robots[index_of(End::right)][2].position = *opponent;
    StalemateMemory memory;
    return ticks_until_called(s, [&, tick = 0](TickFacts turned) mutable {
      turned.ball.x() += shake * std::sin(0.9 * tick++);
      return judge_stalemate(pitch_.pitch(), turned, memory);
    });
  }
};
INSTANTIATE_TEST_SUITE_P(BothEnds, RestingBall, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(RestingBall, GivesAFreeBallInItsQuarter) {
  EXPECT_EQ(wait({0.30, 0.50}), 303) << "9.999 s";
  EXPECT_EQ(called_->verdict, Verdict::FREE_BALL);
  EXPECT_EQ(called_->spot, (attack_sign(GetParam()) * Vec2{0.375, 0.40}));
  EXPECT_EQ(called_->taker, at(End::right)) << "the defender of that half places first";
}

TEST_P(RestingBall, MayShakeWithinOneRobotSide) {
  EXPECT_EQ(wait({0.30, 0.50}, 0.03), 303);
  EXPECT_EQ(wait({0.30, 0.50}, 0.10), 0);
}

// An uncontested ball is judged by the law keeper_hold, where that is on.
TEST_P(RestingBall, InAGoalAreaGivesAGoalKickIfItIsContestedOrNoOtherLawCallsIt) {
  const Vec2 in_area{-0.67, 0.0};
  EXPECT_EQ(wait(in_area), 0);
  EXPECT_EQ(wait(in_area, 0.0, Vec2{-0.60, 0.0}), 303);
  EXPECT_EQ(called_->verdict, Verdict::GOAL_KICK);
  EXPECT_EQ(called_->taker, at(End::left));
  pitch_.rules = make_rules(Preset::simurosot);
  EXPECT_GT(wait(in_area), 0);
  EXPECT_EQ(called_->verdict, Verdict::GOAL_KICK);
}

TEST(Stalemate, StartsAgainWhenTheBallHasMovedOn) {
  const test_support::TestPitch pitch;
  StalemateMemory memory;
  for (int tick = 0; tick < 363; ++tick) {  // 12 s
    const Vec2 ball{tick < 300 ? 0.20 : 0.28, -0.30};
    const TickFacts s = test_support::empty_situation(pitch.field, ball);
    EXPECT_FALSE(judge_stalemate(pitch.pitch(), s, memory));
  }
}

TEST(Quarter, CountsTheMiddleAsNegative) {
  EXPECT_EQ(quarter_of({0.0, 0.0}).x, -1.0);
  EXPECT_EQ(quarter_of({0.0, 0.1}).y, 1.0);
}

}  // namespace
}  // namespace mirocup::referee
