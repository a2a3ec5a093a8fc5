// SPDX-License-Identifier: MIT
//
// Gaps against figures worked out by hand, and against the other order of the two bodies. Catches a
// normal with the wrong sign, a corner taken for an edge, and an edge that is ruled out by mistake.
#include "core/geometry/separation.hpp"

#include "core/base/math.hpp"
#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirocup::geometry {
namespace {

Pose at(double x, double y, double angle = 0.0) {
  return {{x, y}, Heading::from_angle(angle)};
}

TEST(Separation, OfSquaresFaceToFaceIsTheDistanceOfTheFaces) {
  const Outline shape = square(0.2);
  const Separation s = separation(shape, at(0.5, 0.05), shape, at(0.0, 0.0));
  EXPECT_NEAR(s.gap, 0.3, 1e-15);
  EXPECT_NEAR(s.normal.x(), 1.0, 1e-15);
  EXPECT_NEAR(s.reach_a, 0.1, 1e-15);
  EXPECT_NEAR(s.reach_b, 0.1, 1e-15);
}

TEST(Separation, OfACornerAndAFaceIsTheDistanceOfTheCorner) {
  const Outline shape = square(0.2);
  const Separation s = separation(shape, at(0.5, 0.0, pi / 4.0), shape, at(0.0, 0.0));
  EXPECT_NEAR(s.gap, 0.4 - 0.1 * std::sqrt(2.0), 1e-14);
}

TEST(Separation, OfOverlappingSquaresIsMinusTheDepth) {
  const Outline shape = square(0.2);
  const Separation s = separation(shape, at(0.0, -0.17), shape, at(0.03, 0.0));
  EXPECT_NEAR(s.gap, -0.03, 1e-15);
  EXPECT_NEAR(s.normal.y(), -1.0, 1e-15);
}

TEST(Separation, OfACircleBesideACornerIsTheDistanceOfTheCorner) {
  const Separation s =
      separation(circle(0.05), at(0.1 + 0.3, 0.1 + 0.4), square(0.2), at(0.0, 0.0));
  EXPECT_NEAR(s.gap, 0.5 - 0.05, 1e-15);
  EXPECT_NEAR(s.normal.x(), 0.6, 1e-15);
  EXPECT_NEAR(s.normal.y(), 0.8, 1e-15);
}

TEST(Separation, OfAWallIsThatOfTheNearestCorner) {
  field::Wall wall;
  wall.normal = {0.0, 1.0};
  wall.offset = -1.0;
  EXPECT_NEAR(gap(square(0.2), at(3.0, 0.0, pi / 4.0), wall), 1.0 - 0.1 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(gap(circle(0.2), at(3.0, -1.1), wall), -0.3, 1e-15);
}

// The largest separation over all edges, by trying each edge with each corner.
double largest_separation(const Outline& a, const Pose& body_a, const Outline& b,
                          const Pose& body_b) {
  double largest = -infinity;
  for (int edge = 0; edge < a.corners; ++edge) {
    const Vec2 normal = body_a.heading.to_world(a.normal[edge]);
    double nearest = infinity;
    for (int corner = 0; corner < b.corners; ++corner) {
      const Vec2 point = body_b.position + body_b.heading.to_world(b.corner[corner]);
      nearest = std::min(nearest, normal.dot(point - body_a.position) - a.offset[edge]);
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(Separation, IsTheLargestOfAllEdges) {
  Random random(1);
  const std::array<Vec2, 3> corners{Vec2{0.15, 0.0}, Vec2{-0.1, 0.12}, Vec2{-0.1, -0.08}};
  const Outline a = polygon(corners);
  const Outline b = square(0.2);
  for (int i = 0; i < 2000; ++i) {
    const auto pose = [&random] {
      return at(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-pi, pi));
    };
    const Pose body_a = pose();
    const Pose body_b = pose();
    const double expected = std::max(largest_separation(a, body_a, b, body_b),
                                     largest_separation(b, body_b, a, body_a));
    const Separation s = separation(a, body_a, b, body_b);
    ASSERT_NEAR(s.gap, expected, 1e-14) << i;
    const Separation swapped = separation(b, body_b, a, body_a);
    ASSERT_NEAR(swapped.gap, s.gap, 1e-14) << i;
    // Reaches and gap add up to the distance of the reference points along the normal.
    ASSERT_NEAR(s.normal.dot(body_a.position - body_b.position), s.reach_a + s.gap + s.reach_b,
                1e-14);
  }
}

}  // namespace
}  // namespace mirocup::geometry
