// SPDX-License-Identifier: MIT
//
// Outlines against figures worked out by hand. Catches normals that point inwards, edges numbered
// from another corner, and an inner circle that is larger than the polygon.
#include "core/geometry/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::geometry {
namespace {

TEST(Outline, SquareHasItsFrontAsEdgeZero) {
  const Outline shape = square(0.08);
  ASSERT_EQ(shape.corners, 4);
  EXPECT_EQ(shape.normal[0].x(), 1.0);
  EXPECT_EQ(shape.normal[0].y(), 0.0);
  for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(shape.offset[i], 0.04);
  EXPECT_DOUBLE_EQ(shape.radius, std::sqrt(2.0) * 0.04);
  EXPECT_DOUBLE_EQ(shape.inner_radius, 0.04);
}

TEST(Outline, NormalsOfATrianglePointOutwards) {
  const std::array<Vec2, 3> corners{Vec2{0.3, 0.0}, Vec2{-0.1, 0.2}, Vec2{-0.1, -0.1}};
  const Outline shape = polygon(corners);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(shape.normal[i].norm(), 1.0, 1e-15);
    EXPECT_NEAR(shape.normal[i].dot(corners[(i + 1) % 3]), shape.offset[i], 1e-16);
    EXPECT_LT(shape.normal[i].dot(corners[(i + 2) % 3]), shape.offset[i]);
  }
  EXPECT_DOUBLE_EQ(shape.radius, 0.3);
}

TEST(Outline, HasNoInnerCircleAroundAPointOutside) {
  const std::array<Vec2, 3> corners{Vec2{1.0, 0.0}, Vec2{2.0, 0.0}, Vec2{1.5, 1.0}};
  EXPECT_EQ(polygon(corners).inner_radius, -infinity);
}

}  // namespace
}  // namespace mirocup::geometry
