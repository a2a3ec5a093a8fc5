// SPDX-License-Identifier: MIT
//
// Catches a team that may place out of its turn, poses taken for those of the other end, a request
// that changes bits although it changes nothing, an illegal pose that is granted or moved without a
// word, and a replay without the requests.
#include "core/referee/placement_rules.hpp"
#include "core/referee/touches.hpp"
#include "core/replay/verification.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace mirocup::match {
namespace {

using namespace test_support;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// A team that, in its turn, asks for the places that a function makes of its observation.
template <class Change>
Scripted placer(Change change) {
  return Scripted([change](const Observation& o) mutable -> Answer {
    Command command;
    if (!o.placing) return command;
    command.placement = unchanged_request(o);
    change(o, *command.placement);
    return command;
  });
}

// Returns the setup of a leg in which that team kicks off first and that team is at the left end.
Setup with_kick_off(Team team, Team left) {
  for (std::uint64_t seed = 1;; ++seed) {
    const Setup setup = short_setup(seed);
    const Snapshot scene = Leg(setup).snapshot();
    if (scene.taker == team && scene.left == left) return setup;
  }
}

int fixes(const Leg& leg) {
  int count = 0;
  for (const LoggedDecision& d : leg.decisions()) {
    if (d.decision.verdict == referee::Verdict::PLACEMENT_FIXED) ++count;
  }
  return count;
}

TEST(PlacementRequests, TheTakerOfAKickOffPlacesFirstAndTheOpponentsSeeIt) {
  for (const Team taker : both_teams) {
    for (const Team left : both_teams) {
      Leg leg(with_kick_off(taker, left));
      std::vector<Team> turns;
      double seen = 0.0;
      Scripted takes = placer([&](const Observation&, PlacementRequest& poses) {
        turns.push_back(taker);
        poses.robots[2] = {-0.2, 0.3, 0.5};
      });
      Scripted waits = placer([&](const Observation& o, PlacementRequest& poses) {
        turns.push_back(opponent_of(taker));
        seen = o.opponent[2].position.x();
        poses.robots[1] = {-0.5, -0.4, -1.0};
      });
      const bool is_blue = taker == Team::blue;
      for (int i = 0; i < 3; ++i) leg.advance(is_blue ? takes : waits, is_blue ? waits : takes);
      EXPECT_EQ(turns, (std::vector<Team>{taker, opponent_of(taker)}));
      EXPECT_NEAR(seen, 0.2, placement_step) << "its own -0.2, from the other end";
      const Observation own = observe(leg.snapshot(), taker, 3);
      EXPECT_LE((own.own[2].position - Vec2{-0.2, 0.3}).norm(), placement_step);
      EXPECT_NEAR(own.own[2].heading, 0.5, 1e-15);
      const Observation other = observe(leg.snapshot(), opponent_of(taker), 3);
      EXPECT_LE((other.own[1].position - Vec2{-0.5, -0.4}).norm(), placement_step);
      EXPECT_EQ(fixes(leg), 0);
    }
  }
}

// Under `camera` a team leaves everything where it sees it, which is elsewhere.
TEST(PlacementRequests, ARequestThatChangesNothingLeavesNoTrace) {
  for (const auto preset : {ConditionsPreset::exact, ConditionsPreset::camera}) {
    match::Setup setup = short_setup(4);
    setup.conditions = conditions_of(preset);
    Leg plain(setup), asked(setup);
    Scripted a = idle_team(), b = idle_team();
    Scripted c = placer([](const Observation&, PlacementRequest&) {});
    Scripted d = c;
    play(plain, a, b);
    play(asked, c, d);
    EXPECT_EQ(plain.state_hash(), asked.state_hash()) << to_string(preset);
    EXPECT_TRUE(asked.placement_requests().empty()) << to_string(preset);
  }
}

// Catches a request whose last bits, which differ between C libraries, reach the state.
TEST(PlacementRequests, TheLastBitsOfARequestAreRoundedAway) {
  std::array<std::uint64_t, 2> hashes{};
  for (const int i : {0, 1}) {
    Leg leg(with_kick_off(Team::blue, Team::blue));
    Scripted blue = placer([i](const Observation&, PlacementRequest& poses) {
      poses.robots[2] = {-0.31 + i * 1e-14, 0.22 - i * 1e-14, 0.4 + i * 1e-14};
      poses.ball_x = -0.1 + i * 1e-14;
    });
    Scripted yellow = idle_team();
    for (int tick = 0; tick < 3; ++tick) leg.advance(blue, yellow);
    ASSERT_EQ(leg.placement_requests().size(), 1u);
    hashes[i] = leg.state_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(PlacementRequests, OnlyIllegalPosesAreMovedAndTheReasonIsGiven) {
  Leg leg(with_kick_off(Team::blue, Team::blue));
  Scripted blue = placer([](const Observation&, PlacementRequest& poses) {
    poses.robots[0] = {not_a_number, 0.0, 0.0};
    poses.robots[1] = {0.3, 0.0, 0.0};   // beyond the circle
    poses.robots[2] = {-0.3, 0.2, 0.0};  // this one is fine
  });
  Scripted yellow = idle_team();
  leg.advance(blue, yellow);
  ASSERT_EQ(fixes(leg), 1);
  const LoggedDecision& fix = leg.decisions().back();
  EXPECT_EQ(fix.team, Team::blue);
  EXPECT_EQ(fix.robots[0].to_ulong(), 0b011u);
  EXPECT_EQ(fix.decision.reason,
            "blue robot 0 from nowhere to (-0.700, 0.000) m: not inside the walls; "
            "blue robot 1 from (0.300, 0.000) m to (0.157, 0.000) m: not allowed at this restart");
  EXPECT_LE((leg.snapshot().robots[0][2].position - Vec2{-0.3, 0.2}).norm(), placement_step);
}

TEST(PlacementRequests, OnlyTheTakerMayMoveTheBall) {
  for (const Team asker : both_teams) {
    Leg leg(with_kick_off(Team::blue, Team::blue));
    const auto with_ball = placer([](const Observation&, PlacementRequest& poses) {
      poses.ball_x = -0.1;
      poses.ball_y = 0.05;
    });
    Scripted blue = asker == Team::blue ? with_ball : idle_team();
    Scripted yellow = asker == Team::blue ? idle_team() : with_ball;
    for (int i = 0; i < 3; ++i) leg.advance(blue, yellow);
    const bool is_taker = asker == Team::blue;
    const Vec2 expected = is_taker ? Vec2{-0.1, 0.05} : Vec2{0.0, 0.0};
    EXPECT_LE((leg.snapshot().ball.position - expected).norm(), placement_step);
    EXPECT_EQ(fixes(leg), is_taker ? 0 : 1);
    EXPECT_EQ(leg.restart().spot, leg.snapshot().ball.position) << "where the law counts from";
  }
}

TEST(PlacementRequests, RequestsOutOfTurnMoveNothing) {
  Leg leg(with_kick_off(Team::blue, Team::blue));
  Scripted blue = idle_team();
  Scripted always([](const Observation& o) -> Answer {
    Command command;
    command.placement = unchanged_request(o);
    command.placement->robots[1].y = o.placing ? o.own[1].position.y() : 0.5;
    return command;
  });
  const Vec2 before = leg.snapshot().robots[1][1].position;
  for (int i = 0; i < 20; ++i) leg.advance(blue, always);
  EXPECT_EQ(leg.snapshot().robots[1][1].position, before);
}

TEST(PlacementRequests, ALateTeamKeepsItsDefaultPlaces) {
  Leg plain(short_setup(4));
  Leg late(short_setup(4));
  Scripted a = idle_team(), b = idle_team();
  const auto sleeper = [] {
    return Scripted([](const Observation& o) -> Answer {
      if (o.placing) return Late{};
      return Command{};
    });
  };
  Scripted c = sleeper(), d = sleeper();
  play(plain, a, b);
  play(late, c, d);
  EXPECT_EQ(plain.state_hash(), late.state_hash());
  EXPECT_TRUE(late.placement_requests().empty());
  EXPECT_GT(late.late_ticks()[0], 0);
}

// Only where the rules say so. Catches one that is called while play stands, one against the wrong
// team, and a record that does not say what happened.
TEST(PlacementRequests, ARequestOutOfTurnIsAHandOnTheField) {
  for (const Team offender : both_teams) {
    for (const bool is_called : {false, true}) {
      match::Setup setup = short_setup(6);
      setup.rules.hand_penalty = is_called;
      Leg leg(setup);
      Scripted reaches([](const Observation& o) -> Answer {
        Command command;
        if (o.state == State::READY || o.tick == 20) command.placement = unchanged_request(o);
        return command;
      });
      Scripted stands = idle_team();
      const bool is_blue = offender == Team::blue;
      play(leg, is_blue ? reaches : stands, is_blue ? stands : reaches);
      int called = 0;
      for (const LoggedDecision& logged : leg.decisions()) {
        if (logged.decision.law != referee::Law::hand) continue;
        ++called;
        EXPECT_EQ(logged.tick, 20u);
        EXPECT_EQ(logged.team, offender);
        EXPECT_EQ(logged.taker, opponent_of(offender));
        EXPECT_EQ(logged.decision.verdict, referee::Verdict::PENALTY_KICK);
      }
      EXPECT_EQ(called, is_called ? 1 : 0);
      EXPECT_EQ(leg.placement_requests().size(), is_called ? 1u : 0u);
      EXPECT_FALSE(replay::verify(replay::record(leg)));
    }
  }
}

// Both in one tick: the recording holds what each of them did.
TEST(PlacementRequests, RequestsOutOfTurnByBothTeamsAreRecorded) {
  match::Setup setup = short_setup(6);
  setup.rules.hand_penalty = true;
  Leg leg(setup);
  const auto reaching = [] {
    return Scripted([](const Observation& o) -> Answer {
      Command command;
      if (o.tick == 20) command.placement = unchanged_request(o);
      return command;
    });
  };
  Scripted blue = reaching(), yellow = reaching();
  play(leg, blue, yellow);
  const replay::Recording recording = replay::record(leg);
  for (const Team team : both_teams)
    EXPECT_TRUE(requested_in(recording, 20, team)) << to_string(team);
  EXPECT_FALSE(replay::verify(recording));
}

// Any numbers at all, in all leagues and at many restarts: every body stands legally, the leg goes
// on, and it can be played again from its recording alone.
TEST(PlacementRequests, AnyNumbersGiveALegalPlacement) {
  for (const RobotLeague league : {RobotLeague::small, RobotLeague::middle, RobotLeague::large}) {
    match::Setup setup = short_setup(5, league == RobotLeague::large ? 4.0 : 10.0, league);
    setup.rules.stalemate_s = 0.5;
    Leg leg(setup);
    const auto wild = [](std::uint64_t seed) {
      return placer([random = Random(seed)](const Observation& o, PlacementRequest& poses) mutable {
        const auto number = [&]() -> double {
          switch (random.below(8)) {
            case 0:
              return not_a_number;
            case 1:
              return std::numeric_limits<double>::infinity();
            case 2:
              return -1e300;
            default:
              return random.uniform(-1.0, 1.0);
          }
        };
        for (int i = 0; i < o.robots; ++i) poses.robots[i] = {number(), number(), number()};
        poses.ball_x = number();
        poses.ball_y = number();
      });
    };
    Scripted blue = wild(1), yellow = wild(2);
    const referee::JudgedField& pitch = leg.pitch();
    while (!leg.is_over()) {
      leg.advance(blue, yellow);
      const Snapshot scene = leg.snapshot();
      if (scene.state != State::READY) continue;
      std::vector<Pose> placed;
      for (const Team team : both_teams) {
        for (int i = 0; i < leg.field().robots_per_team; ++i) {
          const ObservedRobot& r = scene.robots[index_of(team)][i];
          const Pose pose{r.position, Heading::from_angle(r.heading)};
          ASSERT_TRUE(is_inside_walls(pitch, pose)) << to_string(team) << " " << i;
          ASSERT_GT(ball_gap(pitch, scene.ball.position, pose), 0.0);
          for (const Pose& other : placed) {
            ASSERT_GE(robot_gap(pitch, pose, other, 0.004), 0.004 - 1e-12);
          }
          placed.push_back(pose);
        }
      }
    }
    EXPECT_GT(fixes(leg), 5);
    replay::Recording recording = replay::record(leg);
    EXPECT_FALSE(replay::verify(recording));
    recording.placement_requests.pop_back();
    EXPECT_TRUE(replay::verify(recording)) << "the poses are a part of the leg";
  }
}

TEST(PlacementRequests, BothTeamsHaveATurnHoweverShortTheBreak) {
  match::Setup setup = short_setup(1);
  setup.rules.ready_s = 0.0;
  Leg leg(setup);
  int turns = 0;
  Scripted blue = placer([&](const Observation&, PlacementRequest&) { ++turns; });
  Scripted yellow = placer([&](const Observation&, PlacementRequest&) { ++turns; });
  while (leg.snapshot().state == State::READY) leg.advance(blue, yellow);
  EXPECT_EQ(turns, 2);
}

}  // namespace
}  // namespace mirocup::match
