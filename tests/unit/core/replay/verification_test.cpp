// SPDX-License-Identifier: MIT
//
// Catches a replay that does not notice a changed command, hash, decision, result or length.
#include "core/replay/verification.hpp"

#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

namespace mirocup::replay {
namespace {

using namespace test_support;

Recording played(std::uint64_t seed, double half_s = 10.0) {
  match::Leg leg(test_support::short_setup(seed, half_s));
  Scripted blue = ball_hunter();
  Scripted yellow = random_team(seed);
  StateTrace trace;
  while (!leg.is_over()) {
    leg.advance(blue, yellow);
    trace.add(leg);
  }
  return record(leg, trace);
}

TEST(Verification, ReproducesLegs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto divergence = verify(played(seed));
    EXPECT_FALSE(divergence) << divergence->what;
  }
}

TEST(Verification, FindsAChangedCommandInTheTickAfterIt) {
  Recording r = played(1);
  r.ticks[100].commands[0].wheels[1][0] ^= 1;
  const auto divergence = verify(r);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->tick, 101u);
}

// Catches a trace of another tick or body than it says.
TEST(Verification, NamesTheBodyThatDiffersAndBothItsStates) {
  Recording r = played(1);
  r.ticks[14].commands[1].wheels[2][1] ^= 256;  // no two bodies have met yet
  const auto divergence = verify(r);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->tick, 15u);
  const std::string& what = divergence->what;
  EXPECT_NE(what.find("; yellow robot 2 differs: after tick 90 the record has yellow robot 2 at ("),
            std::string::npos)
      << what;
  EXPECT_NE(what.find(", the replay at ("), std::string::npos) << what;
}

TEST(Verification, ShowsTheStateOfTheVeryTickAtACheckpoint) {
  Recording r = played(1);
  r.ticks[180].hash ^= 1;
  r.trace.ticks[180][6] ^= 1;
  r.trace.checkpoints[2].ball.position.x() = 0.125;
  const auto divergence = verify(r);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->tick, 180u);
  EXPECT_NE(
      divergence->what.find("the ball differs: after tick 180 the record has the ball at (0.125, "),
      std::string::npos)
      << divergence->what;
}

TEST(Verification, WorksWithoutAStateTrace) {
  Recording r = played(1);
  r.trace = {};
  EXPECT_FALSE(verify(r));
  r.ticks[123].hash ^= 1;
  EXPECT_EQ(verify(r)->tick, 123u);
}

TEST(Verification, FindsAForgedTimeAndPlaceOfADecision) {
  Recording clock = played(2);
  clock.decisions.back().decision.clock += 1e-9;
  EXPECT_TRUE(verify(clock));
  Recording ball = played(2);
  ball.decisions.back().decision.ball.y() += 1e-9;
  EXPECT_TRUE(verify(ball));
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
  ++score.outcome.score[0];
  EXPECT_TRUE(verify(score));
  Recording decision = played(2);
  decision.decisions.back().decision.reason += "!";
  EXPECT_TRUE(verify(decision));
  Recording dropped = played(2);
  dropped.decisions.pop_back();
  EXPECT_TRUE(verify(dropped));
}

// Catches a fault that nobody made, another fault than the one that ended the leg, and a call that
// is counted for or against another team.
TEST(Verification, FindsAnInventedFaultAndAForgedPartyOfADecision) {
  Recording fault = played(2);
  fault.outcome.faults.push_back({Team::blue, {match::FaultCode::crash, "signal 11"}});
  EXPECT_TRUE(verify(fault));
  Recording gainer = played(2);
  gainer.decisions.front().parties.gainer.reset();
  EXPECT_TRUE(verify(gainer));
  Recording offender = played(2);
  offender.decisions.front().parties.offender = Team::yellow;
  EXPECT_TRUE(verify(offender));
  Recording running = played(2);
  running.decisions.front().score = match::ByTeam<int>{9, 0};
  EXPECT_TRUE(verify(running));
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
      match::Leg leg(test_support::short_setup(4));
      Scripted blue([&](const match::Observation& o) -> match::Answer {
        if (o.tick < when) return test_support::both_wheels(10.0, 12.0);
        if (host) return match::HostFailure{"killed"};
        return match::Fault{match::FaultCode::crash, "died"};
      });
      Scripted yellow = random_team(2);
      test_support::play(leg, blue, yellow);
      const auto divergence = verify(record(leg));
      EXPECT_FALSE(divergence) << divergence->what;
    }
  }
}

}  // namespace
}  // namespace mirocup::replay
