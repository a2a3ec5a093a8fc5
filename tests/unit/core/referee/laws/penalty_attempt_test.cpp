// SPDX-License-Identifier: MIT
//
// Catches an attempt that does not end, and one that ends while the ball is on its way.
#include "core/referee/laws/penalty_attempt.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class PenaltyAttempt : public test_support::LawTest {
 protected:
  PenaltyAttempt() {
    memory_.is_on = true;
    memory_.taker = at(End::left);
    set_right_keeper();
  }

  // One tick with the ball there; the reason if the attempt is over.
  std::optional<std::string> tick(const Vec2& ball, bool keeper_touches = false) {
    TickFacts s = with_ball(ball);
    s.touched_ball[index_of(End::right)][0] = keeper_touches;
    return judge_penalty_attempt(pitch_.pitch(), seen(s), occupancy_, false, memory_);
  }

  PenaltyAttemptMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, PenaltyAttempt, testing::ValuesIn(both_ends),
                         test_support::end_name);

TEST_P(PenaltyAttempt, EndsAfterThirtySeconds) {
  int ticks = 1;
  while (ticks < 2000 && !tick({0.4, 0.0})) ++ticks;
  EXPECT_NEAR(ticks * 0.033, 30.0, 0.02);
}

TEST_P(PenaltyAttempt, EndsWhenTheBallComesOutOfTheGoalArea) {
  EXPECT_FALSE(tick({0.40, 0.0}));
  EXPECT_FALSE(tick({0.65, 0.0}));
  EXPECT_EQ(tick({0.50, 0.0}), "the ball was in the goal area and is out again");
}

TEST_P(PenaltyAttempt, EndsWhenTheKeeperHoldsTheBallForASecond) {
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(tick({0.65, 0.0}, true)) << i;
  EXPECT_EQ(tick({0.65, 0.0}, true), "the keeper held the ball for 0.99 s");
}

TEST_P(PenaltyAttempt, EndsWhenTheBallGoesBackOverTheHalfLine) {
  EXPECT_FALSE(tick({0.01, 0.0}));
  EXPECT_EQ(tick({-0.01, 0.0}), "the ball went back over the half line");
}

}  // namespace
}  // namespace mirocup::referee
