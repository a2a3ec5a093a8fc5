// SPDX-License-Identifier: MIT
//
// Many short legs in all leagues, presets and stages, between teams that play, teams that drive at
// random and teams that foul. Catches a leg that never ends, an outcome that no law gives, a score
// that differs from the number of goals, a clock that differs from the sum of its ticks, and bodies
// that overlap after a placement.
//
// MIROCUP_SOAK_MATCHES is the number of legs; without it there are as many as a test run can
// afford.
#include "core/referee/placement_rules.hpp"
#include "core/referee/touches.hpp"
#include "tests/support/offenders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

namespace mirocup::match {
namespace {

constexpr int default_legs = 36;
constexpr double max_seconds = 3000.0;  // s of simulated time, stoppages included

test_support::Scripted controller(std::uint64_t kind, std::uint64_t seed, const Setup& setup) {
  const double goal_line = field::make_field(setup.league).half_length;
  switch (kind) {
    case 0:
      return test_support::idle_team();
    case 1:
      return test_support::random_team(seed);
    case 2:
      return test_support::goal_parkers(goal_line);
    case 3:
      return test_support::raiders(goal_line);
    case 4:
      return test_support::man_hunters();
    default:
      return test_support::ball_hunter();
  }
}

// The same team, which also asks for legal and illegal places at restarts, sometimes out of its
// turn.
test_support::Scripted restless(test_support::Scripted team, std::uint64_t seed,
                                const Setup& setup) {
  const field::Field field = field::make_field(setup.league);
  return test_support::Scripted(
      [team, random = Random(seed), field](const Observation& o) mutable -> Answer {
        team.post(o);
        Answer answer = team.collect();
        auto* command = std::get_if<Command>(&answer);
        if (command == nullptr || (!o.placing && random.below(300) > 0)) return answer;
        command->placement = unchanged_request(o);
        const auto within = [&random](double size) { return random.uniform(-1.1, 1.1) * size; };
        for (int i = 0; i < o.robots; ++i) {
          if (random.coin()) continue;
          command->placement->robots[i] = {within(field.half_length), within(field.half_width),
                                           within(3.0)};
        }
        if (random.coin()) command->placement->ball_y += within(0.2);
        return answer;
      });
}

Setup setup_of(int number) {
  Random random(mix_seed(static_cast<std::uint64_t>(number)));
  Setup setup;
  setup.league = static_cast<RobotLeague>(number % 3);
  const auto preset = static_cast<referee::Preset>(number / 3 % 3);
  setup.rules = referee::make_rules(preset, setup.league);
  setup.stage = random.coin() ? referee::Stage::knockout : referee::Stage::group;
  setup.seed = random.next();
  setup.control_period = match::control_period_of(preset);
  // Short phases, so that every phase is reached, and short limits of time to match.
  setup.rules.half_s = setup.league == RobotLeague::large ? 3.0 : random.uniform(5.0, 15.0);
  setup.rules.golden_goal_s = setup.rules.golden_goal_s > 0.0 ? 4.0 : 0.0;
  setup.rules.extra_halves_s = setup.rules.extra_halves_s > 0.0 ? 3.0 : 0.0;
  setup.rules.attempt_s = 3.0;
  setup.rules.shoot_out_most_rounds = 6;
  setup.rules.stalemate_s = 3.0;
  if (setup.rules.keeper_hold_s != referee::off) setup.rules.keeper_hold_s = 2.0;
  setup.rules.hand_penalty = random.coin();
  return setup;
}

void expect_legal(const Leg& leg) {
  const referee::JudgedField& pitch = leg.pitch();
  const Snapshot scene = leg.snapshot();
  std::vector<Pose> placed;
  for (const Team team : both_teams) {
    for (int i = 0; i < leg.field().robots_per_team; ++i) {
      const ObservedRobot& r = scene.robots[index_of(team)][i];
      const Pose pose{r.position, Heading::from_angle(r.heading)};
      EXPECT_TRUE(is_inside_walls(pitch, pose)) << to_string(team) << " " << i;
      EXPECT_GT(ball_gap(pitch, scene.ball.position, pose), 0.0) << to_string(team) << " " << i;
      for (const Pose& other : placed) {
        EXPECT_GE(robot_gap(pitch, pose, other, 0.004), 0.004 - 1e-12)
            << to_string(team) << " " << i;
      }
      placed.push_back(pose);
    }
  }
}

// Plays a leg, checks every tick, and counts the decisions by law.
void soak(int number, std::map<std::string, int>& laws) {
  const Setup setup = setup_of(number);
  Random random(mix_seed(setup.seed));
  Leg leg(setup);
  auto blue = controller(random.below(7), random.next(), setup);
  auto yellow = controller(random.below(7), random.next(), setup);
  if (random.coin()) blue = restless(blue, random.next(), setup);
  if (random.coin()) yellow = restless(yellow, random.next(), setup);
  while (!leg.is_over() && leg.tick() * setup.control_period < max_seconds) {
    const Snapshot before = leg.snapshot();
    leg.advance(blue, yellow);
    const Snapshot after = leg.snapshot();
    const double passed = after.clock - before.clock;
    if (after.phase == before.phase && after.left == before.left) {
      const double expected = before.state == State::PLAY ? setup.control_period : 0.0;
      ASSERT_NEAR(passed, expected, 1e-9) << "tick " << before.tick;
    }
    const bool was_placed = before.placing || before.state == State::PLAY;
    if (after.state != State::END && was_placed && after.placing != before.placing) {
      expect_legal(leg);
    }
  }
  ASSERT_TRUE(leg.is_over()) << "the leg hangs in " << to_string(leg.snapshot().phase)
                             << ", last: " << leg.decisions().back().decision.reason;
  const Outcome& result = leg.outcome();
  ByTeam<int> goals{};
  for (const LoggedDecision& d : leg.decisions()) {
    ++laws[std::string(to_string(d.decision.law)) + " " +
           std::string(to_string(d.decision.verdict))];
    if (d.decision.verdict == referee::Verdict::GOAL) ++goals[index_of(*d.team)];
  }
  EXPECT_EQ(goals, result.played);
  EXPECT_EQ(leg.decisions().back().decision.verdict, referee::Verdict::MATCH_END);
  EXPECT_TRUE(result.winner || setup.stage == referee::Stage::group) << "knock-out has a winner";
  const bool level = goals[0] == goals[1];
  EXPECT_EQ(result.kind == OutcomeKind::shoot_out,
            level && setup.stage == referee::Stage::knockout);
}

TEST(Soak, EveryLegEndsByALawAndItsScoreAddsUp) {
  const char* wanted = std::getenv("MIROCUP_SOAK_MATCHES");
  const int legs = wanted != nullptr ? std::atoi(wanted) : default_legs;
  std::map<std::string, int> laws;
  for (int number = 0; number < legs; ++number) {
    SCOPED_TRACE("leg " + std::to_string(number));
    soak(number, laws);
    if (HasFatalFailure()) return;
  }
  int decisions = 0;
  for (const auto& [law, count] : laws) {
    std::printf("%-32s %6d\n", law.c_str(), count);
    decisions += count;
  }
  std::printf("%d legs, %.1f decisions a leg\n", legs,
              static_cast<double>(decisions) / std::max(legs, 1));
  // Teams that foul on purpose are called for what they do.
  for (const char* law :
       {"goal GOAL", "own_goal GOAL", "kick_off KICK_OFF_VIOLATION", "two_defenders PENALTY_KICK",
        "two_attackers GOAL_KICK", "keeper_charge GOAL_KICK", "stalemate FREE_BALL",
        "push FREE_KICK", "attacking_push FREE_BALL", "half_time HALF_END", "extra_time PHASE",
        "shoot_out PHASE", "penalty_attempt ATTEMPT_END", "shoot_out MATCH_END",
        "placement PLACEMENT_FIXED", "hand PENALTY_KICK"}) {
    EXPECT_GT(laws[law], 0) << law << " was never seen";
  }
}

}  // namespace
}  // namespace mirocup::match
