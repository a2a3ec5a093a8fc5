// SPDX-License-Identifier: MIT
//
// Catches a command that acts a tick too early or too late, robots that move while play is stopped,
// an end that is better than the other, and a fault that costs the wrong team.
#include "core/match/leg.hpp"

#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

namespace mirocup::match {
namespace {

using namespace test_support;

TEST(Leg, CommandsActOneTickAfterTheirObservation) {
  Leg leg(short_setup(1));
  Scripted yellow = idle_team();
  std::uint32_t first_play = 0;
  Scripted blue([&](const Observation& o) -> Answer {
    if (o.state != State::PLAY) return Command{};
    if (first_play == 0) first_play = o.tick;
    return both_wheels(30.0, 30.0);
  });
  while (first_play == 0) leg.advance(blue, yellow);
  const auto speed = [&] { return leg.snapshot().robots[0][0].velocity.norm(); };
  EXPECT_EQ(speed(), 0.0) << "the tick whose observation it answers";
  leg.advance(blue, yellow);
  EXPECT_GT(speed(), 0.0) << "the tick after";
}

TEST(Leg, RobotsStandUntilTheWhistle) {
  Leg leg(short_setup(1));
  Scripted blue = random_team(1);
  Scripted yellow = random_team(2);
  int ready_ticks = 0;
  while (leg.snapshot().state == State::READY) {
    leg.advance(blue, yellow);
    ++ready_ticks;
    EXPECT_EQ(leg.snapshot().robots[0][1].velocity.norm(), 0.0);
  }
  EXPECT_EQ(ready_ticks, 10) << "0.33 s";
  EXPECT_EQ(leg.snapshot().clock, 0.0);
}

TEST(Leg, TwoHalvesSwapEndsAndKickOffs) {
  Leg leg(short_setup(3));
  Scripted blue = idle_team();
  Scripted yellow = idle_team();
  const Team left = leg.snapshot().left;
  const Team first_kick_off = leg.snapshot().taker;
  play(leg, blue, yellow);
  EXPECT_EQ(leg.outcome().kind, OutcomeKind::full_time);
  EXPECT_EQ(leg.outcome().score, (ByTeam<int>{0, 0}));
  EXPECT_FALSE(leg.outcome().winner);
  EXPECT_EQ(leg.snapshot().left, opponent_of(left));
  EXPECT_EQ(leg.snapshot().taker, opponent_of(first_kick_off));
  const double stoppages = 2 * 10 * 0.033;
  EXPECT_NEAR(leg.tick() * 0.033, 6.0 + stoppages, 2 * 0.033 + 1e-9);
}

TEST(Leg, TheScoreIsTheNumberOfGoalDecisions) {
  // Blue hunts the ball and yellow runs at random; over a few seeds there are goals.
  ByTeam<int> total{};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Leg leg(short_setup(seed, 30.0));
    Scripted blue = ball_hunter();
    Scripted yellow = random_team(seed);
    play(leg, blue, yellow);
    ByTeam<int> goals{};
    for (const LoggedDecision& d : leg.decisions()) {
      if (d.decision.verdict == referee::Verdict::GOAL) ++goals[index_of(*d.team)];
    }
    EXPECT_EQ(goals, leg.outcome().played);
    total[0] += goals[0];
    total[1] += goals[1];
  }
  EXPECT_GT(total[0], 3);
}

// Which end a team has must not matter: with the ends swapped the leg is the same, turned by 180
// degrees, bit for bit, under every condition. The rules have one exception, which is ruled out
// here: a free ball for a ball on a centre line, whose quarter counts as negative at both ends.
TEST(Leg, SwappedEndsPlayTheSameLegBitForBit) {
  for (const auto& [league, preset] : {std::pair(RobotLeague::small, ConditionsPreset::exact),
                                       std::pair(RobotLeague::middle, ConditionsPreset::exact),
                                       std::pair(RobotLeague::small, ConditionsPreset::hall),
                                       std::pair(RobotLeague::small, ConditionsPreset::camera),
                                       std::pair(RobotLeague::middle, ConditionsPreset::camera)}) {
    auto setup_a = short_setup(8, 20.0, league);
    setup_a.conditions = conditions_of(preset);
    setup_a.rules.stalemate_s = 1000.0;
    setup_a.rules.push_dist_m = 1000.0;
    setup_a.left = Team::blue;
    auto setup_b = setup_a;
    setup_b.left = Team::yellow;
    SCOPED_TRACE(to_string(preset));
    Leg a(setup_a);
    Leg b(setup_b);
    Scripted blue_a = ball_hunter(), yellow_a = random_team(7);
    Scripted blue_b = ball_hunter(), yellow_b = random_team(7);
    while (!a.is_over()) {
      a.advance(blue_a, yellow_a);
      b.advance(blue_b, yellow_b);
      const Snapshot sa = a.snapshot();
      const Snapshot sb = b.snapshot();
      ASSERT_EQ(sa.ball.position, -sb.ball.position) << "tick " << sa.tick;
      ASSERT_EQ(sa.ball.velocity, -sb.ball.velocity) << "tick " << sa.tick;
      for (int i = 0; i < a.field().robots_per_team; ++i) {
        for (int t = 0; t < 2; ++t) {
          ASSERT_EQ(sa.robots[t][i].position, -sb.robots[t][i].position) << "tick " << sa.tick;
          ASSERT_EQ(sa.robots[t][i].heading, half_turned(sb.robots[t][i].heading));
          ASSERT_EQ(sa.robots[t][i].velocity, -sb.robots[t][i].velocity);
          ASSERT_EQ(sa.robots[t][i].turn, sb.robots[t][i].turn);
        }
      }
      ASSERT_EQ(sa.score, sb.score);
    }
    EXPECT_TRUE(b.is_over());
  }
}

TEST(Leg, AFaultCostsTheTeamThatMadeIt) {
  for (const Team offender : both_teams) {
    Leg leg(short_setup(1));
    Scripted fails([](const Observation& o) -> Answer {
      if (o.tick == 20) return Fault{FaultCode::crash, "died"};
      return Command{};
    });
    Scripted plays = idle_team();
    play(leg, offender == Team::blue ? fails : plays, offender == Team::blue ? plays : fails);
    const Outcome& r = leg.outcome();
    EXPECT_EQ(r.kind, OutcomeKind::forfeit);
    EXPECT_EQ(r.winner, opponent_of(offender));
    EXPECT_EQ(r.score[index_of(offender)], 0);
    EXPECT_EQ(r.score[index_of(opponent_of(offender))], 10);
    ASSERT_EQ(r.faults.size(), 1u);
    EXPECT_EQ(r.faults[0].team, offender);
  }
}

TEST(Leg, TwoFaultsInOneTickCostBoth) {
  Leg leg(short_setup(1));
  const auto fail = [](const Observation&) -> Answer { return Fault{FaultCode::hang, "stuck"}; };
  Scripted blue(fail), yellow(fail);
  play(leg, blue, yellow);
  EXPECT_EQ(leg.outcome().kind, OutcomeKind::double_forfeit);
  EXPECT_FALSE(leg.outcome().winner);
}

TEST(Leg, AHostFailureMakesTheLegVoidAndCostsNoTeam) {
  Leg leg(short_setup(1));
  Scripted blue([](const Observation&) -> Answer { return HostFailure{"disk full"}; });
  Scripted yellow([](const Observation&) -> Answer { return Fault{FaultCode::crash, "died"}; });
  play(leg, blue, yellow);
  EXPECT_EQ(leg.outcome().kind, OutcomeKind::void_);
  EXPECT_TRUE(leg.outcome().faults.empty());
}

TEST(Leg, ALateTeamRepeatsItsLastCommandForThreeTicksThenStands) {
  Leg leg(short_setup(1));
  Scripted yellow = idle_team();
  Scripted blue([](const Observation& o) -> Answer {
    if (o.tick < 20) return both_wheels(20.0, 20.0);
    return Late{};
  });
  while (leg.tick() < 30) leg.advance(blue, yellow);
  const auto& log = leg.log();
  for (int t : {20, 21, 22}) EXPECT_EQ(log[t].commands[0], log[19].commands[0]) << t;
  EXPECT_EQ(log[23].commands[0], DrivenCommand{});
  EXPECT_EQ(leg.late_ticks()[0], 10);
}

// Catches answers that always come a tick too late and are thrown away, so that the robots stand.
TEST(Leg, ALateTeamDrivesItsOlderCommandsAndIsCountedAsLate) {
  Leg leg(short_setup(1));
  Scripted yellow = idle_team();
  Scripted blue([](const Observation& o) -> Answer {
    if (o.tick < 3) return both_wheels(20.0, 20.0);
    if (o.tick % 2 == 0) return Late{};
    return Late{both_wheels(o.tick, 10.0)};
  });
  while (leg.tick() < 30) leg.advance(blue, yellow);
  for (int t = 4; t < 30; ++t) {
    const double expected = t % 2 == 0 ? t - 1 : t;
    EXPECT_EQ(leg.log()[t].commands[0].speeds(0).left, expected) << t;
  }
  EXPECT_EQ(leg.late_ticks()[0], 27);
}

// Catches a leg that takes memory for all the ticks that a record claims: 7.6 GB for two halves of
// ten hours in steps of a millisecond.
TEST(Leg, TakesNoMemoryForTicksThatAreOnlyClaimed) {
  match::Setup setup;
  setup.rules.half_s = 36000.0;
  setup.control_period = 1e-3;
  EXPECT_LE(Leg(setup).log().capacity(), 100'000u);
}

}  // namespace
}  // namespace mirocup::match
