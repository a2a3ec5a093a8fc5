// SPDX-License-Identifier: MIT
//
// Catches statistics that do not come from the leg that was played.
#include "server/web/statistics.hpp"
#include "server/web/track_encoder.hpp"
#include "tests/support/controllers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace mirocup::web {
namespace {

Statistics of(match::Leg& match, match::Controller& blue, match::Controller& yellow) {
  Statistics statistics(match.field());
  statistics.add(match);
  while (!match.is_over()) {
    match.advance(blue, yellow);
    statistics.add(match);
  }
  return statistics;
}

// One team drives, the other stands: all distance and possession are the driver's.
TEST(Statistics, CreditTheTeamThatPlays) {
  match::Setup setup = test_support::short_setup(1, 20.0);
  setup.rules.mercy_goal_diff = 0;
  match::Leg match(setup);
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::idle_team();
  const Statistics s = of(match, blue, yellow);
  const TeamStatistics& hunter = s.of(Team::blue);
  const TeamStatistics& idler = s.of(Team::yellow);
  const auto total = [](const TeamStatistics& n) {
    return std::accumulate(n.distance.begin(), n.distance.end(), 0.0);
  };
  EXPECT_GT(total(hunter), 5.0);
  EXPECT_LT(total(hunter), 40.0 * 3 * 1.8) << "three robots at full speed for the whole match";
  EXPECT_GT(hunter.possession, idler.possession);
  EXPECT_LE(hunter.possession + idler.possession, 40.1);
  EXPECT_EQ(idler.shots, 0);
  const int ticks_of_play = std::accumulate(s.heat().begin(), s.heat().end(), 0);
  EXPECT_NEAR(ticks_of_play * setup.control_period, 40.0, 40.0 * 0.1);
}

TEST(TrackEncoder, KeepsHeadingsContinuousAcrossAHalfTurn) {
  match::Snapshot scene;
  scene.robots[0][0].heading = 3.1;
  const Frame before = frame_of(scene, 1, {});
  scene.robots[0][0].heading = -3.1;
  const Frame after = frame_of(scene, 1, before);
  EXPECT_LT(std::abs(after[5] - before[5]), 40) << "a turn is 2048";
}

}  // namespace
}  // namespace mirocup::web
