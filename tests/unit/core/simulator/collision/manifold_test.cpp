// SPDX-License-Identifier: MIT
#include "core/simulator/collision/manifold.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace mirocup::simulator::collision {
namespace {

std::vector<double> gaps_of(const ContactPoints& found) {
  std::vector<double> gaps;
  for (int i = 0; i < found.count; ++i) gaps.push_back(found.points[i].gap);
  return gaps;
}

// Pairs that cannot be within the margin are ruled out early. Catches one that is ruled out too
// early, also where corner faces corner.
TEST(Manifold, MarginLeavesOutFartherPointsOnly) {
  constexpr double side = 0.075;
  constexpr double margin = 0.01;
  const geometry::Outline square_shape = geometry::square(side);
  Random random(7);
  int within = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Pose a{.position = {0.3, -0.2}, .heading = Heading::from_angle(random.uniform(-pi, pi))};
    const Heading towards = Heading::from_angle(random.uniform(-pi, pi));
    const Pose b{.position = a.position + random.uniform(side, 1.7 * side) * towards.forward(),
                 .heading = Heading::from_angle(random.uniform(-pi, pi))};
    const double separation = reference_of(square_shape, a, square_shape, b).best.separation;
    std::vector<double> expected;
    if (separation <= margin) {
      for (const double gap : gaps_of(contact_points(square_shape, a, square_shape, b, infinity))) {
        if (gap <= margin) expected.push_back(gap);
      }
    }
    within += !expected.empty();
    ASSERT_EQ(gaps_of(contact_points(square_shape, a, square_shape, b, margin)), expected)
        << "case " << i;
  }
  EXPECT_GT(within, 5'000);
}

}  // namespace
}  // namespace mirocup::simulator::collision
