// SPDX-License-Identifier: MIT
//
// Catches a view that shows the present, one whose noise has another size, a lost body whose age
// does not count, and the jump of a restart that is taken for a velocity.
#include "core/match/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::match {
namespace {

constexpr double period = 0.033;

// Everything stands but the ball, which rolls along x at 1 m/s.
Snapshot rolling(std::uint32_t tick) {
  Snapshot s;
  s.tick = tick;
  s.ball = {{tick * period, 0.1}, {1.0, 0.0}};
  return s;
}

TEST(Camera, ShowsWhereTheBodiesWereBefore) {
  Conditions c;
  c.delay_ticks = 2;
  Camera camera(c, 1, 3, period);
  for (std::uint32_t tick = 0; tick < 10; ++tick) {
    camera.look(rolling(tick), tick == 0);
    const double seen_tick = tick < 2 ? 0.0 : tick - 2.0;
    EXPECT_EQ(camera.view().ball.position.x(), seen_tick * period) << "tick " << tick;
    EXPECT_EQ(camera.view().ball_age, static_cast<int>(tick - seen_tick));
  }
  EXPECT_NEAR(camera.view().ball.velocity.x(), 1.0, 1e-12);
}

TEST(Camera, NoiseHasTheSizeThatTheConditionsSay) {
  Conditions c;
  c.see_sigma_m = 0.0015;
  Camera camera(c, 1, 3, period);
  double squares = 0.0;
  constexpr int n = 20000;
  for (std::uint32_t tick = 0; tick < n; ++tick) {
    camera.look(rolling(tick), false);
    const double error = camera.view().ball.position.y() - 0.1;
    EXPECT_LE(std::abs(error), 0.003 + 1e-12);
    squares += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / n), 0.88 * 0.0015, 0.05 * 0.0015);
}

TEST(Camera, HoldsTheLastPoseOfALostBodyAndCountsItsAge) {
  Conditions c;
  c.unseen_rate = 0.1;
  c.unseen_mean_ticks = 3.0;
  Camera camera(c, 1, 3, period);
  int lost = 0, spans = 0, last_age = 0;
  constexpr int n = 20000;
  for (std::uint32_t tick = 0; tick < n; ++tick) {
    camera.look(rolling(tick), false);
    const int age = camera.view().ball_age;
    ASSERT_TRUE(age == 0 || age == last_age + 1) << "tick " << tick;
    EXPECT_EQ(camera.view().ball.position.x(), (tick - static_cast<unsigned>(age)) * period);
    EXPECT_TRUE(age == 0 || tick < 3 || std::abs(camera.view().ball.velocity.x() - 1.0) < 1e-9)
        << "the velocity of the last two sightings";
    lost += age > 0 ? 1 : 0;
    spans += age == 1 ? 1 : 0;
    last_age = age;
  }
  EXPECT_NEAR(static_cast<double>(lost) / spans, 3.0, 0.2);
  EXPECT_NEAR(static_cast<double>(spans) / (n - lost), 0.1, 0.01);
}

TEST(Camera, TakesNoPlacingForAMotion) {
  Camera camera({.delay_ticks = 1}, 1, 3, period);
  Snapshot s = rolling(0);
  camera.look(s, true);
  s = rolling(1);
  camera.look(s, false);
  s.tick = 2;
  s.ball.position = {-1.0, 0.0};
  camera.look(s, true);
  s.tick = 3;
  camera.look(s, false);
  EXPECT_EQ(camera.view().ball.position.x(), -1.0);
  EXPECT_EQ(camera.view().ball.velocity, Vec2(0.0, 0.0));
}

}  // namespace
}  // namespace mirocup::match
