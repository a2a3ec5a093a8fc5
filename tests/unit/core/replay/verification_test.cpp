// SPDX-License-Identifier: MIT
//
// Catches a replay that does not notice a changed command, hash, decision, result or length.
#include "core/replay/verification.hpp"

#include "tests/support/contains.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace mirocup::replay {
namespace {

using namespace test_support;

Recording played(std::uint64_t seed, double half_s = 10.0) {
  match::Leg leg(test_support::short_setup(seed, half_s));
  Scripted blue = ball_hunter();
  Scripted yellow = random_team(seed);
  return played_and_traced(leg, blue, yellow);
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
  EXPECT_TRUE(
      contains(what, "; yellow robot 2 differs: after tick 90 the record has yellow robot 2 at ("));
  EXPECT_TRUE(contains(what, ", the replay at ("));
}

TEST(Verification, ShowsTheStateOfTheVeryTickAtACheckpoint) {
  Recording r = played(1);
  r.ticks[180].hash ^= 1;
  r.trace.ticks[180][6] ^= 1;
  r.trace.checkpoints[2].ball.position.x() = 0.125;
  const auto divergence = verify(r);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->tick, 180u);
  EXPECT_TRUE(contains(divergence->what,
                       "the ball differs: after tick 180 the record has the ball at (0.125, "));
}

TEST(Verification, WorksWithoutAStateTrace) {
  Recording r = played(1);
  r.trace = {};
  EXPECT_FALSE(verify(r));
  r.ticks[123].hash ^= 1;
  EXPECT_EQ(verify(r)->tick, 123u);
}

// Catches a key of a record that is not compared with the replay.
TEST(Verification, FindsEveryForgery) {
  using Forge = void (*)(Recording&);
  const std::pair<const char*, Forge> forgeries[] = {
      {"a tick less", [](Recording& r) { r.ticks.pop_back(); }},
      {"a tick more", [](Recording& r) { r.ticks.push_back(r.ticks.back()); }},
      {"score", [](Recording& r) { ++r.outcome.score[0]; }},
      {"a fault that nobody made",
       [](Recording& r) {
         r.outcome.faults.push_back({Team::blue, {match::FaultCode::crash, "signal 11"}});
       }},
      {"a decision less", [](Recording& r) { r.decisions.pop_back(); }},
      {"reason", [](Recording& r) { r.decisions.back().decision.reason += "!"; }},
      {"clock", [](Recording& r) { r.decisions.back().decision.clock += 1e-9; }},
      {"place", [](Recording& r) { r.decisions.back().decision.ball.y() += 1e-9; }},
      {"gainer", [](Recording& r) { r.decisions.front().parties.gainer.reset(); }},
      {"offender", [](Recording& r) { r.decisions.front().parties.offender = Team::yellow; }},
      {"running score", [](Recording& r) {
         r.decisions.front().score = match::ByTeam<int>{9, 0};
       }}};
  const Recording whole = played(2);
  for (const auto& [what, forge] : forgeries) {
    Recording forged = whole;
    forge(forged);
    EXPECT_TRUE(verify(forged)) << what;
  }
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
