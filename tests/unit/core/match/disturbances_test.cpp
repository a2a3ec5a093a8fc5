// SPDX-License-Identifier: MIT
//
// Catches draws that depend on the order in which robots are asked, a distribution of another width
// or with tails, and one disturbance that changes the draws of another.
#include "core/match/disturbances.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::match {
namespace {

TEST(CutNormal, HasTheMomentsOfANormalDistributionCutAtTwoSigma) {
  Random random(1);
  constexpr int n = 200000;
  double sum = 0.0, squares = 0.0, largest = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = cut_normal(random);
    sum += x;
    squares += x * x;
    largest = std::max(largest, std::abs(x));
  }
  EXPECT_LE(largest, 2.0);
  EXPECT_GT(largest, 1.99);
  EXPECT_NEAR(sum / n, 0.0, 0.01);
  // 1 - 2 * 2 phi(2) / (2 Phi(2) - 1)
  EXPECT_NEAR(squares / n, 0.77374, 0.01);
}

TEST(Disturbances, OfARobotDoNotDependOnWhatOthersDraw) {
  const Conditions hall = conditions_of(ConditionsPreset::hall);
  Disturbances alone(hall, 5, 3);
  Disturbances among_others(hall, 5, 3);
  for (int i = 0; i < 3; ++i) among_others.put_down_robot(Team::blue, i);
  among_others.put_down_ball();
  const PlacingError a = alone.put_down_robot(Team::yellow, 1);
  const PlacingError b = among_others.put_down_robot(Team::yellow, 1);
  EXPECT_EQ(a.offset, b.offset);
  EXPECT_EQ(a.turn, b.turn);
}

TEST(Disturbances, ThatAreOffChangeNoOtherDraw) {
  Conditions hall = conditions_of(ConditionsPreset::hall);
  Disturbances with(hall, 5, 3);
  hall.wheel_jitter_sigma = 0.0;
  hall.rolling_sigma = 0.0;
  Disturbances without(hall, 5, 3);
  EXPECT_EQ(with.put_down_robot(Team::blue, 0).offset,
            without.put_down_robot(Team::blue, 0).offset);
  EXPECT_EQ(without.rolling_factor(), 1.0);
  EXPECT_NE(with.rolling_factor(), 1.0);
}

// Catches a future that is drawn with other robots, or as the leg was.
TEST(Disturbances, ThatAreDrawnAnewKeepGainsAndFloor) {
  Disturbances leg(conditions_of(ConditionsPreset::hall), 5, 3);
  Disturbances future = leg;
  future.redraw(6);
  EXPECT_EQ(future.rolling_factor(), leg.rolling_factor());
  EXPECT_NE(future.drive(Team::blue, 0, {40.0, 40.0}).left,
            leg.drive(Team::blue, 0, {40.0, 40.0}).left);
  future.redraw(5);
  Disturbances again(conditions_of(ConditionsPreset::hall), 5, 3);
  EXPECT_EQ(future.drive(Team::blue, 0, {40.0, 40.0}).left,
            again.drive(Team::blue, 0, {40.0, 40.0}).left);
}

TEST(Disturbances, AWheelHasOneGainForTheLegAndANewJitterInEveryTick) {
  Conditions c;
  c.wheel_gain_sigma = 0.01;
  Disturbances gains(c, 9, 3);
  const auto first = gains.drive(Team::blue, 2, {40.0, 40.0});
  const auto second = gains.drive(Team::blue, 2, {40.0, 40.0});
  EXPECT_EQ(first.left, second.left);
  EXPECT_NE(first.left, first.right);
  EXPECT_NEAR(first.left, 40.0, 40.0 * 0.02);

  c = {};
  c.wheel_jitter_sigma = 0.01;
  Disturbances jitter(c, 9, 3);
  EXPECT_NE(jitter.drive(Team::blue, 2, {40.0, 40.0}).left,
            jitter.drive(Team::blue, 2, {40.0, 40.0}).left);
  EXPECT_EQ(jitter.drive(Team::blue, 2, {0.0, 0.0}).left, 0.0) << "a robot told to stand stands";
}

TEST(Disturbances, ALostCommandLeavesTheWheelsAtTheLastOne) {
  Conditions c;
  c.radio_loss = 0.25;
  Disturbances radio(c, 4, 1);
  int held = 0;
  double last = 0.0;
  constexpr int ticks = 4000;
  for (int t = 1; t <= ticks; ++t) {
    const double speed = radio.drive(Team::yellow, 0, {double(t), double(t)}).left;
    EXPECT_TRUE(speed == t || speed == last) << "tick " << t;
    held += speed != t ? 1 : 0;
    last = speed;
  }
  EXPECT_NEAR(held, ticks * 0.25, 4.0 * std::sqrt(ticks * 0.25 * 0.75));
}

}  // namespace
}  // namespace mirocup::match
