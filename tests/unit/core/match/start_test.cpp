// SPDX-License-Identifier: MIT
//
// Legs that start elsewhere than at a kick-off.
#include "core/match/start.hpp"

#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

namespace mirocup::match {
namespace {

using namespace test_support;

RobotStart robot_at(double x, double y, double angle) {
  return {.state = simulator::BodyState({x, y}, Heading::from_angle(angle), {}),
          .wheels = {},
          .is_broken = false};
}

Start in_play() {
  Start start;
  start.ball = simulator::BallState{.position = {0.2, 0.1}, .velocity = {0.5, -0.25}};
  start.robots[0][0] = robot_at(-0.7, 0.0, 1.5);
  start.robots[0][1] = robot_at(-0.2, 0.3, 0.3);
  start.robots[0][1].state->twist.forward = 0.5;
  start.robots[0][1].wheels = {20.0, 24.0};
  start.robots[1][0] = robot_at(0.6, -0.2, 2.0);
  start.phase = referee::Phase::SECOND_HALF;
  start.clock = 1.5;
  start.score = {2, 1};
  return start;
}

Setup setup_at(const Start& start, ConditionsPreset preset = ConditionsPreset::exact) {
  Setup setup = short_setup(5, 10.0);
  setup.start = start;
  setup.conditions = conditions_of(preset);
  return setup;
}

// The start turned by 180 degrees.
Start turned(Start start) {
  start.left = opponent_of(start.left);
  if (start.ball)
    start.ball = {.position = -start.ball->position, .velocity = -start.ball->velocity};
  for (auto& team : start.robots) {
    for (RobotStart& robot : team) {
      if (!robot.state) continue;
      robot.state->position = -robot.state->position;
      robot.state->heading = robot.state->heading.half_turned();
    }
  }
  if (start.restart)
    start.restart->quarter = {-start.restart->quarter.x, -start.restart->quarter.y};
  return start;
}

// Catches a start whose velocities, clock, score or first commands are lost.
TEST(LegStart, PlayIsOnAtOnceWithEveryNumberThatWasGiven) {
  Leg leg(setup_at(in_play()));
  const Snapshot begin = leg.snapshot();
  EXPECT_EQ(begin.state, State::PLAY);
  EXPECT_EQ(begin.phase, referee::Phase::SECOND_HALF);
  EXPECT_EQ(begin.clock, 1.5);
  EXPECT_EQ(begin.score, (ByTeam<int>{2, 1}));
  EXPECT_EQ(begin.ball.velocity, Vec2(0.5, -0.25));
  EXPECT_EQ(leg.robot(Team::blue, 1).twist.forward, 0.5);
  Scripted blue = idle_team();
  Scripted yellow = idle_team();
  leg.advance(blue, yellow);
  const double driven = leg.robot(Team::blue, 1).twist.omega;
  EXPECT_GT(driven, 0.1) << "the wheels of the start turn it in the first tick";
  test_support::play(leg, blue, yellow);
  EXPECT_GE(leg.outcome().score[0], 2) << "the goals of the start count";
}

// Catches a start that favours an end, also where hands place what it leaves out.
TEST(LegStart, TurnedPlaysTheSameLegBitForBit) {
  Start free_ball;
  free_ball.restart = {
      .kind = referee::Restart::FREE_BALL, .taker = Team::yellow, .quarter = {1.0, -1.0}};
  free_ball.robots[0][2] = robot_at(-0.4, 0.45, 0.7);
  for (const Start& start : {in_play(), free_ball}) {
    match::Setup there = setup_at(start, ConditionsPreset::camera);
    there.rules.stalemate_s = there.rules.push_dist_m = 1000.0;
    match::Setup turned_round = there;
    turned_round.start = turned(start);
    Leg a(there), b(turned_round);
    Scripted blue_a = ball_hunter(), yellow_a = random_team(7);
    Scripted blue_b = ball_hunter(), yellow_b = random_team(7);
    while (!a.is_over()) {
      a.advance(blue_a, yellow_a);
      b.advance(blue_b, yellow_b);
      ASSERT_EQ(a.ball().position, -b.ball().position) << "tick " << a.tick();
      for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(a.robot(Team::blue, i).position, -b.robot(Team::blue, i).position);
        ASSERT_EQ(a.robot(Team::yellow, i).position, -b.robot(Team::yellow, i).position);
      }
    }
    EXPECT_TRUE(b.is_over());
  }
}

// Catches a broken robot that is driven, and a whole one that is not.
TEST(LegStart, ABrokenRobotStands) {
  Start start = in_play();
  start.robots[0][2] = robot_at(-0.5, -0.5, 0.0);
  start.robots[0][2].is_broken = true;
  Leg leg(setup_at(start));
  Scripted blue([](const Observation&) -> Answer { return test_support::both_wheels(9.0, 9.0); });
  Scripted yellow = idle_team();
  for (int i = 0; i < 20; ++i) leg.advance(blue, yellow);
  EXPECT_EQ(leg.robot(Team::blue, 2).position, Vec2(-0.5, -0.5));
  EXPECT_NE(leg.robot(Team::blue, 0).position, Vec2(-0.7, 0.0));
}

// Catches a restart without its whistle, and a hand that moves what the start has placed.
TEST(LegStart, ARestartWaitsForTheWhistleWithGivenRobotsWhereTheyWerePut) {
  Start start;
  start.restart = {.kind = referee::Restart::PENALTY_KICK, .taker = Team::blue, .quarter = {}};
  start.robots[0][2] = robot_at(-0.3, -0.45, 0.25);
  Leg leg(setup_at(start, ConditionsPreset::hall));
  const Snapshot begin = leg.snapshot();
  EXPECT_EQ(begin.restart, referee::Restart::PENALTY_KICK);
  EXPECT_EQ(begin.taker, Team::blue);
  EXPECT_EQ(begin.placing, Team::yellow);
  EXPECT_EQ(leg.robot(Team::blue, 2).position, Vec2(-0.3, -0.45));
  EXPECT_NE(leg.robot(Team::blue, 1).position, Vec2(0.3, 0.0)) << "put down by hand";
  EXPECT_NEAR(leg.robot(Team::blue, 1).position.x(), 0.3, 0.01);
  Scripted blue = idle_team();
  Scripted yellow = idle_team();
  int ready_ticks = 0;
  for (; leg.snapshot().state == State::READY; ++ready_ticks) leg.advance(blue, yellow);
  EXPECT_EQ(ready_ticks, 10) << "0.33 s";
}

}  // namespace
}  // namespace mirocup::match
