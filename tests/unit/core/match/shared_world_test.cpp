// SPDX-License-Identifier: MIT
//
// Catches a world that forgets something when a leg lays it aside: contacts, thresholds, forces of
// time steps, the rolling resistance of the leg; and one that computes with scratch of another leg.
// Then legs that take turns in one world go another way than alone.
#include "core/match/leg.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <memory>
#include <tuple>
#include <vector>

namespace mirocup::match {
namespace {

using namespace test_support;

// A leg and its teams. Those of even seeds hunt the ball, so there are heaps in which robots are
// time-stepped; the others drive at random, so wheels slide.
struct Play {
  Play(const Setup& setup, simulator::World* shared)
      : leg(shared == nullptr ? std::make_unique<Leg>(setup)
                              : std::make_unique<Leg>(setup, TickLogs::kept, *shared)),
        blue(setup.seed % 2 == 0 ? ball_hunter() : random_team(setup.seed)),
        yellow(setup.seed % 2 == 0 ? ball_hunter() : random_team(setup.seed + 1)),
        seed(setup.seed) {
    if (shared != nullptr) leg->lay_aside();
  }

  void advance_in(simulator::World& world) {
    leg->take_up(world);
    leg->advance(blue, yellow);
    leg->lay_aside();
  }

  std::unique_ptr<Leg> leg;
  Scripted blue, yellow;
  std::uint64_t seed;
};

// Plays legs of these seeds by turns in one world, and each alone.
void expect_same_alone(Setup setup, std::initializer_list<std::uint64_t> seeds) {
  const auto field = field::make_field(setup.league);
  simulator::World world(&field, setup.parameters, setup.tolerances, 2 * field.robots_per_team,
                         true);
  std::vector<Play> together;
  for (const std::uint64_t seed : seeds) {
    setup.seed = seed;
    together.emplace_back(setup, &world);
  }
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (Play& play : together) {
      if (play.leg->is_over()) continue;
      play.advance_in(world);
      goes_on = true;
    }
  }
  for (Play& play : together) {
    setup.seed = play.seed;
    Play alone(setup, nullptr);
    test_support::play(*alone.leg, alone.blue, alone.yellow);
    EXPECT_EQ(play.leg->state_hash(), alone.leg->state_hash()) << play.seed;
    for (int i = 0; i < field.robots_per_team; ++i) {
      EXPECT_TRUE(std::isfinite(alone.leg->robot(Team::blue, i).position.x())) << play.seed;
    }
  }
}

class SharedWorld : public testing::TestWithParam<
                        std::tuple<RobotLeague, ConditionsPreset, simulator::Accuracy>> {};

// Among these are legs of the middle and of the large league that went another way: redundant
// contacts kept terms of their forces that an earlier leg had left.
TEST_P(SharedWorld, LegsThatTakeTurnsPlayAsAlone) {
  const auto& [league, conditions, accuracy] = GetParam();
  auto setup = short_setup(1, accuracy == simulator::Accuracy::reference ? 0.5 : 1.5, league);
  setup.conditions = conditions_of(conditions);
  setup.tolerances = simulator::tolerances_of(accuracy);
  expect_same_alone(setup, {1, 6, 8, 22, 24});
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedWorld,
    testing::Combine(testing::Values(RobotLeague::small, RobotLeague::middle, RobotLeague::large),
                     testing::Values(ConditionsPreset::exact, ConditionsPreset::hall,
                                     ConditionsPreset::camera),
                     testing::Values(simulator::Accuracy::coarse, simulator::Accuracy::standard,
                                     simulator::Accuracy::reference)));

// Catches a loaded world that takes contacts for closed which the saved one has not closed yet.
TEST(LoadedWorld, HasTheContactsOfTheSavedOneAtCoarse) {
  auto setup = short_setup(1, 1.5);
  setup.tolerances = simulator::tolerances_of(simulator::Accuracy::coarse);
  setup.parameters.contact_friction = {0.3, 0.3, 0.3, 0.3};
  expect_same_alone(setup, {7, 9});
}

// Catches tick logs that cost or change something where they are dropped.
TEST(TickLogs, DroppedChangeNoPlay) {
  auto setup = short_setup(2, 4.0);
  setup.conditions = conditions_of(ConditionsPreset::hall);
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
