// SPDX-License-Identifier: MIT
//
// Catches a world that forgets something when a leg lays it aside: contacts, thresholds, forces of
// time steps, the rolling resistance of the leg. Then legs that take turns in one world go another
// way than alone.
#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

namespace mirocup::match {
namespace {

using test_support::ball_hunter;
using test_support::random_team;
using test_support::Scripted;
using test_support::short_setup;

// A leg and its teams. Those of even seeds hunt the ball, so there are heaps in which robots are
// time-stepped; the others drive at random, so wheels slide.
struct Play {
  Play(const Setup& setup, simulator::World* shared)
      : leg(shared == nullptr ? std::make_unique<Leg>(setup)
                              : std::make_unique<Leg>(setup, TickLogs::kept, *shared)),
        blue(setup.seed % 2 == 0 ? ball_hunter() : random_team(setup.seed)),
        yellow(setup.seed % 2 == 0 ? ball_hunter() : random_team(setup.seed + 1)) {
    if (shared != nullptr) leg->lay_aside();
  }

  void advance_in(simulator::World& world) {
    leg->take_up(world);
    leg->advance(blue, yellow);
    leg->lay_aside();
  }

  std::unique_ptr<Leg> leg;
  Scripted blue, yellow;
};

Setup setup_of(std::uint64_t seed, ConditionsPreset conditions) {
  Setup setup = short_setup(seed, 4.0);
  setup.conditions = conditions_of(conditions);
  return setup;
}

TEST(SharedWorld, LegsThatTakeTurnsPlayAsAlone) {
  for (const auto conditions : {ConditionsPreset::hall, ConditionsPreset::camera}) {
    const auto first = setup_of(1, conditions);
    const auto field = field::make_field(first.league);
    simulator::World world(&field, first.parameters, first.tolerances, 2 * field.robots_per_team,
                           true);
    std::vector<Play> together;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      together.emplace_back(setup_of(seed, conditions), &world);
    }
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (Play& play : together) {
        if (play.leg->is_over()) continue;
        play.advance_in(world);
        goes_on = true;
      }
    }
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Play alone(setup_of(seed, conditions), nullptr);
      test_support::play(*alone.leg, alone.blue, alone.yellow);
      EXPECT_EQ(together[seed - 1].leg->state_hash(), alone.leg->state_hash()) << seed;
    }
  }
}

// Catches tick logs that cost or change something where they are dropped.
TEST(SharedWorld, DroppedTickLogsChangeNoPlay) {
  const auto setup = setup_of(2, ConditionsPreset::hall);
  Leg kept(setup), dropped(setup, TickLogs::dropped);
  Scripted a = ball_hunter(), b = ball_hunter(), c = ball_hunter(), d = ball_hunter();
  for (int i = 0; i < 120; ++i) {
    kept.advance(a, b);
    dropped.advance(c, d);
  }
  EXPECT_EQ(kept.log().size(), 120U);
  EXPECT_TRUE(dropped.log().empty());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(kept.robot(Team::blue, i).position, dropped.robot(Team::blue, i).position);
    EXPECT_EQ(kept.robot(Team::yellow, i).twist.omega, dropped.robot(Team::yellow, i).twist.omega);
  }
  EXPECT_EQ(kept.ball().position, dropped.ball().position);
}

}  // namespace
}  // namespace mirocup::match
