// SPDX-License-Identifier: MIT
//
// The edges over which robots come to overlap, for all four sides of a square.
#include "core/simulator/collision/reference_edges.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::simulator::collision {
namespace {

// Two squares, of which one is on the other's left side as seen from `turned` (rad), and beside it
// by these gaps, m: ahead, and to the left. Negative where the projections overlap.
struct Gaps {
  double ahead, left;
};
std::array<BodyState, 2> off_diagonal(const StaticWorld& world, double turned, const Gaps& gaps) {
  const double side = world.parameters.robot_side;
  const Heading heading = Heading::from_angle(turned);
  const Vec2 place{side + gaps.ahead, side + gaps.left};
  return {BodyState{{0.0, 0.0}, heading, {}}, BodyState{heading.to_world(place), heading, {}}};
}

// Returns the direction of the contacts after a motion from these gaps to those, seen from the
// first square.
Vec2 direction_after(double turned, const Gaps& from, const Gaps& to) {
  const StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  const auto begin = off_diagonal(world, turned, from);
  const auto end = off_diagonal(world, turned, to);
  ContactList list;
  add_contacts(world, pair_of(0, 1), end, 1e-3, list);
  use_reference_edges(world, begin, end, list);
  EXPECT_EQ(list.count, 2) << turned;
  const Contact& c = list.list[0];
  EXPECT_NEAR(c.point.gap,
              std::abs(end[0].heading.to_body(c.point.normal).x()) > 0.5 ? to.ahead : to.left,
              1e-12);
  const Vec2 normal = end[0].heading.to_body(c.point.normal);
  return c.b == 0 ? normal : Vec2{-normal};
}

class ReferenceEdges : public testing::TestWithParam<double> {};

// Catches the edge that is nearest at the end: it pushes past a corner that was not passed.
TEST_P(ReferenceEdges, AreTheLastSeparatingEdges) {
  const Vec2 direction = direction_after(GetParam(), {1e-5, -5e-6}, {-3e-5, -5e-6});
  EXPECT_NEAR(direction.x(), 1.0, 1e-9);
}

// At the end they are apart, but were not all the time. Catches a function that skips pairs without
// overlap.
TEST_P(ReferenceEdges, StopABodyThatWouldPassThrough) {
  const Vec2 direction = direction_after(GetParam(), {1e-5, -5e-6}, {-3e-5, 1e-5});
  EXPECT_NEAR(direction.x(), 1.0, 1e-9);
}

// Catches a function that uses the start of the step only.
TEST_P(ReferenceEdges, LetABodyPastTheCornerGoOn) {
  const Vec2 direction = direction_after(GetParam(), {1e-5, -5e-6}, {-3e-5, 3e-5});
  EXPECT_NEAR(direction.y(), 1.0, 1e-9);
}

// Catches a function that takes the rounding of a gap for an overlap.
TEST_P(ReferenceEdges, OfTouchingBodiesAreTheTouchingEdges) {
  const Vec2 direction = direction_after(GetParam(), {-1e-11, -5e-6}, {-2e-5, -5e-6});
  EXPECT_NEAR(direction.x(), 1.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Headings, ReferenceEdges,
                         testing::Values(0.0, 0.5 * pi, 0.3, 0.3 + pi, -0.9, -0.5 * pi));

}  // namespace
}  // namespace mirocup::simulator::collision
