// SPDX-License-Identifier: MIT
//
// Moments of inertia in closed form. Catches a polygon's sum with a wrong factor, and one that
// takes the polygon for its square.
#include "core/simulator/model/parameters.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator {
namespace {

Parameters with_corners(std::initializer_list<Vec2> corners) {
  Parameters p;
  for (const Vec2& corner : corners) {
    p.robot_corners.x[p.robot_corners.corners] = corner.x();
    p.robot_corners.y[p.robot_corners.corners++] = corner.y();
  }
  return p;
}

TEST(Parameters, InertiaIsThatOfTheShape) {
  const double a = 0.08, b = 0.05;
  const Parameters rectangle = with_corners(
      {{a / 2.0, -b / 2.0}, {a / 2.0, b / 2.0}, {-a / 2.0, b / 2.0}, {-a / 2.0, -b / 2.0}});
  EXPECT_NEAR(rectangle.robot_inertia(), rectangle.robot_mass * (a * a + b * b) / 12.0, 1e-18);
  const double r = a / std::sqrt(3.0);
  const Parameters triangle = with_corners({{r, 0.0}, {-r / 2.0, a / 2.0}, {-r / 2.0, -a / 2.0}});
  EXPECT_NEAR(triangle.robot_inertia(), triangle.robot_mass * a * a / 12.0, 1e-18);
}

}  // namespace
}  // namespace mirocup::simulator
