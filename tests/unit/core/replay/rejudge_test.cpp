// SPDX-License-Identifier: MIT
//
// Catches a difference where no rule was changed, and a changed law without one.
#include "core/replay/rejudge.hpp"

#include "tests/support/offenders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::replay {
namespace {

Recording played() {
  match::Leg leg(test_support::short_setup(4, 20.0));
  auto blue = test_support::raiders(leg.field().half_length);
  auto yellow = test_support::idle_team();
  test_support::play(leg, blue, yellow);
  return record(leg);
}

TEST(Rejudging, TheSameRulesGiveNoDifference) {
  const Recording recording = played();
  ASSERT_GT(recording.decisions.size(), 5u);
  const auto differences = rejudge(recording, recording.setup.rules);
  ASSERT_TRUE(differences);
  EXPECT_TRUE(differences->empty());
}

TEST(Rejudging, EveryCallOfALawSwitchedOffIsADifference) {
  const Recording recording = played();
  const auto is_foul = [](const match::LoggedDecision& d) {
    return (d.decision.law == referee::Law::keeper_charge ||
            d.decision.law == referee::Law::two_attackers) &&
           d.decision.verdict == referee::Verdict::GOAL_KICK;
  };
  const auto calls = std::count_if(recording.decisions.begin(), recording.decisions.end(), is_foul);
  ASSERT_GT(calls, 0);
  referee::Rules rules = recording.setup.rules;
  rules.att_max = 0;
  rules.charge_s = referee::off;
  rules.charge_speed_mps = referee::off;
  const auto differences = rejudge(recording, rules);
  ASSERT_TRUE(differences);
  const auto missed =
      std::count_if(differences->begin(), differences->end(),
                    [&](const Difference& d) { return d.given && is_foul(*d.given); });
  EXPECT_EQ(missed, calls);
}

// Catches a judgement of a leg that was not played as the recording says.
TEST(Rejudging, ARecordingThatIsNotReproducedIsNotJudged) {
  Recording score = played();
  ++score.outcome.score[0];
  EXPECT_FALSE(rejudge(score, score.setup.rules));
  Recording hash = played();
  hash.ticks[50].hash ^= 1;
  const auto judged = rejudge(hash, hash.setup.rules);
  ASSERT_FALSE(judged);
  EXPECT_EQ(judged.error().tick, 50u);
}

TEST(Rejudging, AShorterHalfIsReportedOnce) {
  const Recording recording = played();
  referee::Rules rules = recording.setup.rules;
  rules.half_s = 15.0;
  int ends = 0;
  const auto differences = rejudge(recording, rules);
  ASSERT_TRUE(differences);
  for (const Difference& d : *differences) {
    ends += d.would_be && d.would_be->decision.verdict == referee::Verdict::HALF_END ? 1 : 0;
  }
  EXPECT_EQ(ends, 1);
}

}  // namespace
}  // namespace mirocup::replay
