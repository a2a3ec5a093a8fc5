// SPDX-License-Identifier: MIT
//
// The ball alone against the closed form. Catches a ball that creeps on instead of stopping, and
// one that curves.
#include "core/simulator/trajectory/rolling_ball.hpp"

#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

BodyState rolled(const Parameters& p, BodyState ball, double duration) {
  double t = 0.0;
  for (int i = 0; i < 1000 && t < duration; ++i) {
    const Segment s = roll(rolling_deceleration(p), ball, t, duration);
    ball = body_at(s, s.end);
    t = s.end;
  }
  EXPECT_EQ(t, duration);
  return ball;
}

TEST(RollingBall, FollowsTheClosedForm) {
  const Parameters p;
  const BodyState ball{{0.1, 0.2}, Heading{}, {0.6, -0.8, 0.0}};
  const BodyState end = rolled(p, ball, 0.5);
  const test_support::ExactBall exact =
      test_support::roll_exactly(p, {0.1L, 0.2L, 0.6L, -0.8L}, 0.5L);
  EXPECT_NEAR(end.position.x(), static_cast<double>(exact.x), 1e-12);
  EXPECT_NEAR(end.position.y(), static_cast<double>(exact.y), 1e-12);
  EXPECT_NEAR(end.twist.forward, static_cast<double>(exact.vx), 1e-12);
}

TEST(RollingBall, StopsAtItsStoppingTimeAndLiesStill) {
  const Parameters p;
  const double stops = stopping_time(rolling_deceleration(p), 0.05);
  const BodyState ball{{0.0, 0.0}, Heading{}, {0.05, 0.0, 0.0}};
  EXPECT_GT(rolled(p, ball, 0.99 * stops).twist.forward, 0.0);
  const BodyState end = rolled(p, ball, 1.01 * stops);
  EXPECT_EQ(end.twist.forward, 0.0);
  EXPECT_EQ(end.position.x(), rolled(p, ball, 2.0 * stops).position.x());
}

TEST(RollingBall, StoppingTimeWithoutViscousFrictionIsSpeedByDeceleration) {
  EXPECT_DOUBLE_EQ(stopping_time({.constant = 0.5, .linear = 0.0}, 2.0), 4.0);
  EXPECT_DOUBLE_EQ(stopping_time({.constant = 0.5, .linear = 0.1}, 2.0), std::log(1.4) / 0.1);
  EXPECT_EQ(stopping_time({.constant = 0.0, .linear = 0.1}, 2.0), never);
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
