// SPDX-License-Identifier: MIT
//
// Catches a count that a shaken ball restarts, one that never restarts, a free ball in the wrong
// quarter, and the wrong law inside a goal area.
#include "core/referee/laws/stalemate.hpp"

#include "core/referee/laws/keeper_hold.hpp"
#include "tests/support/pitch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::referee {
namespace {

using namespace test_support;

// A decision and how long the ball had lain until then, s.
struct TimedDecision {
  std::optional<Decision> decision;
  double after = 0.0;
};

class RestingBall : public testing::TestWithParam<End> {
 protected:
  // Judges a ball that lies, or shakes, at a place until a law calls it; nothing after 33 s.
  TimedDecision wait(const Vec2& ball, double shake = 0.0,
                     std::optional<Vec2> opponent = std::nullopt) {
    StalemateMemory stalemate;
    KeeperHoldMemory hold;
    for (int tick = 0; tick < 1000; ++tick) {
      Situation s = empty_situation(pitch_.field, ball + Vec2{shake * std::sin(0.9 * tick), 0.0});
      if (opponent) s.robots[index_of(End::right)][2].position = *opponent;
      if (GetParam() == End::right) s = half_turned(s);
      auto decision = judge_keeper_hold(pitch_.pitch(), s, hold);
      if (!decision) decision = judge_stalemate(pitch_.pitch(), s, stalemate);
      if (decision) return {decision, 0.033 * (tick + 1)};
    }
    return {};
  }

  End me() const { return GetParam(); }

  TestPitch pitch_;
};
INSTANTIATE_TEST_SUITE_P(SeenBy, RestingBall, testing::Values(End::left, End::right),
                         [](const auto& end) { return std::string(to_string(end.param)); });

TEST_P(RestingBall, GivesAFreeBallInItsQuarter) {
  const TimedDecision v = wait({0.30, 0.50});
  ASSERT_TRUE(v.decision);
  EXPECT_EQ(v.decision->verdict, Verdict::FREE_BALL);
  EXPECT_NEAR(v.after, 10.0, 0.04);
  const Vec2 mark = attack_sign(me()) * Vec2{0.375, 0.40};
  EXPECT_EQ(v.decision->spot, mark);
  EXPECT_EQ(v.decision->taker, opposite(me())) << "the defender of that half places first";
}

TEST_P(RestingBall, MayShakeWithinOneRobotSide) {
  EXPECT_NEAR(wait({0.30, 0.50}, 0.03).after, 10.0, 0.04);
  EXPECT_FALSE(wait({0.30, 0.50}, 0.10).decision);
}

TEST_P(RestingBall, UncontestedInTheOwnGoalAreaCostsAPenalty) {
  const TimedDecision v = wait({-0.67, 0.0});
  ASSERT_TRUE(v.decision);
  EXPECT_EQ(v.decision->verdict, Verdict::PENALTY_KICK);
  EXPECT_EQ(v.decision->team, me());
  EXPECT_EQ(v.decision->taker, opposite(me()));
  EXPECT_NEAR(v.after, 10.0, 0.04);
}

TEST_P(RestingBall, ContestedInAGoalAreaGivesAGoalKick) {
  const TimedDecision v = wait({-0.67, 0.0}, 0.0, Vec2{-0.60, 0.0});
  ASSERT_TRUE(v.decision);
  EXPECT_EQ(v.decision->verdict, Verdict::GOAL_KICK);
  EXPECT_EQ(v.decision->taker, me());
}

TEST_P(RestingBall, IsContestedByOpponentsWithinOneAndAHalfSides) {
  EXPECT_EQ(wait({-0.67, 0.0}, 0.0, Vec2{-0.67 + 0.1124, 0.0}).decision->verdict,
            Verdict::GOAL_KICK);
  EXPECT_EQ(wait({-0.67, 0.0}, 0.0, Vec2{-0.67 + 0.1126, 0.0}).decision->verdict,
            Verdict::PENALTY_KICK);
}

TEST_P(RestingBall, UncontestedWithoutThatLawGivesAGoalKick) {
  pitch_.rules = make_rules(Preset::simurosot);
  EXPECT_EQ(wait({-0.67, 0.0}).decision->verdict, Verdict::GOAL_KICK);
}

TEST(Stalemate, StartsAgainWhenTheBallHasMovedOn) {
  const TestPitch pitch;
  StalemateMemory memory;
  for (int tick = 0; tick < 363; ++tick) {  // 12 s
    const Vec2 ball{tick < 300 ? 0.20 : 0.28, -0.30};
    EXPECT_FALSE(judge_stalemate(pitch.pitch(), empty_situation(pitch.field, ball), memory));
  }
}

TEST(Quarter, CountsTheMiddleAsNegative) {
  EXPECT_EQ(quarter_of({0.0, 0.0}).x, -1.0);
  EXPECT_EQ(quarter_of({0.0, 0.1}).y, 1.0);
}

}  // namespace
}  // namespace mirocup::referee
