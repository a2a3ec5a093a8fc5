// SPDX-License-Identifier: MIT
//
// Catches a forward kick-off that goes unseen, a backward one that is called, a clock that does not
// run.
#include "core/referee/laws/kick_off.hpp"

#include "tests/support/law_test.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

class KickOff : public test_support::LawTest {
 protected:
  KickOff() {
    memory_.is_pending = true;
    memory_.taker = at(End::left);
  }

  std::optional<Decision> roll(const Vec2& from, const Vec2& to, bool touch = true) {
    TickFacts s = with_ball(to);
    s.ball_before = from;
    s.touched_ball[index_of(End::left)][1] = touch;
    return judge_kick_off(pitch_.pitch(), seen(s), memory_);
  }

  KickOffMemory memory_;
};
INSTANTIATE_TEST_SUITE_P(BothEnds, KickOff, testing::ValuesIn(both_ends), test_support::end_name);

TEST_P(KickOff, BackwardsIsFine) {
  EXPECT_FALSE(roll({0.0, 0.0}, {-0.049, 0.01}));
  EXPECT_FALSE(roll({-0.049, 0.01}, {-0.06, 0.01}));
  EXPECT_FALSE(roll({-0.06, 0.01}, {0.10, 0.01})) << "once it went home, it may go anywhere";
}

TEST_P(KickOff, ForwardsPassesItToTheOpponents) {
  EXPECT_FALSE(roll({0.0, 0.0}, {0.049, 0.0}));
  const auto violation = roll({0.049, 0.0}, {0.052, 0.0});
  expect_call(violation, Verdict::KICK_OFF_VIOLATION, End::left, End::right);
  EXPECT_EQ(violation->restart, Restart::KICK_OFF);
}

TEST_P(KickOff, IsJudgedWhereTheBallLeavesTheCircleNotWhereItEnds) {
  // Within one tick out over the front of the circle and far home again on the other side of it:
  // the straight line leaves at the back.
  EXPECT_FALSE(roll({0.04, 0.0}, {-0.2, 0.0}));
}

TEST_P(KickOff, MustBeTakenInTime) {
  std::optional<Decision> late;
  int ticks = 0;
  while (!late && ticks < 1000) {
    late = roll({0.0, 0.0}, {0.0, 0.0}, false);
    ++ticks;
  }
  EXPECT_NEAR(ticks * 0.033, 5.0, 0.034);
}

TEST_P(KickOff, ATouchStopsTheClock) {
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(roll({0.0, 0.0}, {0.0, 0.0}, true));
  for (int i = 0; i < 400; ++i) EXPECT_FALSE(roll({0.0, 0.0}, {0.0, 0.0}, false));
}

TEST_P(KickOff, MayGoForwardsUnderOtherRules) {
  pitch_.rules = make_rules(Preset::vsss);
  EXPECT_FALSE(roll({0.0, 0.0}, {0.06, 0.0}));
}

}  // namespace
}  // namespace mirocup::referee
