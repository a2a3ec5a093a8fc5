// SPDX-License-Identifier: MIT
//
// Catches a replay that does not notice a changed command, hash, decision, result or length.
#include "core/replay/verification.hpp"

#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

namespace mirocup::replay {
namespace {

using test_support::ball_hunter;
using test_support::random_team;
using test_support::Scripted;

Recording played(std::uint64_t seed, double half_s = 10.0) {
  match::Match match(test_support::short_setup(seed, half_s));
  Scripted blue = ball_hunter();
  Scripted yellow = random_team(seed);
  test_support::play(match, blue, yellow);
  return record(match);
}

TEST(Verification, ReproducesALeg) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto divergence = verify(played(seed));
    EXPECT_FALSE(divergence) << divergence->what;
  }
}

TEST(Verification, FindsAChangedCommandInTheTickAfterIt) {
  Recording r = played(1);
  r.ticks[200].commands[1].wheels[0][0] ^= 1;
  const auto divergence = verify(r);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->tick, 201u);
}

TEST(Verification, FindsAChangedHash) {
  Recording r = played(1);
  r.ticks[123].hash ^= 1;
  const auto divergence = verify(r);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->tick, 123u);
}

TEST(Verification, FindsAForgedScoreAndAForgedDecision) {
  Recording score = played(2);
  ++score.result.score[0];
  EXPECT_TRUE(verify(score));
  Recording decision = played(2);
  decision.decisions.back().decision.reason += "!";
  EXPECT_TRUE(verify(decision));
  Recording dropped = played(2);
  dropped.decisions.pop_back();
  EXPECT_TRUE(verify(dropped));
}

TEST(Verification, FindsMissingAndAddedTicks) {
  Recording shorter = played(1);
  shorter.ticks.pop_back();
  EXPECT_TRUE(verify(shorter));
  Recording longer = played(1);
  longer.ticks.push_back(longer.ticks.back());
  EXPECT_TRUE(verify(longer));
}

TEST(Verification, ReproducesForfeitsAndVoidLegs) {
  for (const std::uint32_t when : {0u, 50u}) {
    for (const bool host : {false, true}) {
      match::Match match(test_support::short_setup(4));
      Scripted blue([&](const match::Observation& o) -> match::Answer {
        if (o.tick < when) return test_support::both_wheels(10.0, 12.0);
        if (host) return match::HostFailure{"killed"};
        return match::Fault{match::FaultCode::crash, "died"};
      });
      Scripted yellow = random_team(2);
      test_support::play(match, blue, yellow);
      const auto divergence = verify(record(match));
      EXPECT_FALSE(divergence) << divergence->what;
    }
  }
}

}  // namespace
}  // namespace mirocup::replay
