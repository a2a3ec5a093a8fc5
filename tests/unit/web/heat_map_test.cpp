// SPDX-License-Identifier: MIT
//
// Catches a heat map that does not come from the leg that was played.
#include "web/heat_map.hpp"

#include "tests/support/controllers.hpp"
#include "web/track_encoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace mirocup::web {
namespace {

TEST(HeatMap, CountsTheTicksOfPlay) {
  match::Setup setup = test_support::short_setup(1, 20.0);
  setup.rules.mercy_goal_diff = 0;
  match::Leg leg(setup);
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::idle_team();
  HeatMap heat(leg.field());
  heat.add(leg.snapshot());
  while (!leg.is_over()) {
    leg.advance(blue, yellow);
    heat.add(leg.snapshot());
  }
  const int ticks_of_play = std::accumulate(heat.cells().begin(), heat.cells().end(), 0);
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
