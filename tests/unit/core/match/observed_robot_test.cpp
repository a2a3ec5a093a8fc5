// SPDX-License-Identifier: MIT
//
// Catches a heading that a program in the field's frame would compute with other bits than the
// match: then the same team would play differently as a library and over the network.
#include "core/match/observed_robot.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::match {
namespace {

bool is_multiple_of_step(double angle) {
  const double steps = angle * 0x1p50;
  return steps == std::nearbyint(steps);
}

void expect_exact(const Heading& heading) {
  const double angle = observed_angle(heading);
  EXPECT_TRUE(is_multiple_of_step(angle)) << angle;
  EXPECT_NEAR(std::remainder(angle - heading.angle(), 2.0 * pi), 0.0, 0x1p-49);
  EXPECT_GT(angle, -pi);
  EXPECT_LE(angle, pi);
  // The opposite heading is the angle that a client computes without the unit vector.
  EXPECT_EQ(observed_angle(heading.half_turned()), half_turned(angle)) << angle;
  EXPECT_EQ(half_turned(half_turned(angle)), angle);
}

TEST(ObservedAngle, IsTurnedByExactlyPi) {
  Random random(7);
  for (int i = 0; i < 200000; ++i) {
    expect_exact(Heading::from_angle(2.0 * pi * (random.uniform() - 0.5)));
  }
  // Near the axes, where an angle has more digits than the half-turned one.
  for (double small = 1.0; small > 1e-30; small /= 3.0) {
    for (const double axis : {0.0, 0.5 * pi, pi, -0.5 * pi}) {
      expect_exact(Heading::from_angle(axis + small));
      expect_exact(Heading::from_angle(axis - small));
    }
    expect_exact({1.0, small});
    expect_exact({-1.0, small});
    expect_exact({1.0, -small});
    expect_exact({-1.0, -small});
  }
}

TEST(ObservedAngle, IsExactOnTheAxes) {
  EXPECT_EQ(observed_angle({1.0, 0.0}), 0.0);
  EXPECT_EQ(observed_angle({1.0, -0.0}), 0.0);
  EXPECT_EQ(observed_angle({0.0, 1.0}), 0.5 * pi);
  EXPECT_EQ(observed_angle({-0.0, 1.0}), 0.5 * pi);
  EXPECT_EQ(observed_angle({0.0, -1.0}), -0.5 * pi);
  EXPECT_EQ(observed_angle({-1.0, 0.0}), pi);
  EXPECT_EQ(observed_angle({-1.0, -0.0}), pi);
}

}  // namespace
}  // namespace mirocup::match
