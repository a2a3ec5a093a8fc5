// SPDX-License-Identifier: MIT
//
// Rows of contacts as series against differences of the gap itself.
#include "core/simulator/resting_contact/contact_series.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup::simulator::resting_contact {
namespace {

// Terms 0 and 1 of the gap's rate against central differences of the gap of bodies that keep
// their twists.
void expect_rates_of_the_gap(const collision::StaticWorld& world,
                             const std::array<BodyState, 2>& bodies) {
  collision::ContactList list;
  add_contacts(world, pair_of(1, 0), bodies, 1e-3, list);
  ASSERT_EQ(list.count, 1);
  const collision::Contact& c = list.list[0];
  std::array<trajectory::Segment, 2> segments;
  for (int i = 0; i < 2; ++i) segments[i] = trajectory::steady_segment(bodies[i], 0.0, 1e-3);
  ContactSeries rows;
  start_rows(world, c, segments, rows);
  std::array<double, 2> rate{gap_rate_term(c, 0, rows), 0.0};
  extend_rows(world, c, 0, rows);
  rate[1] = gap_rate_term(c, 1, rows);

  const double h = 1e-4;
  const auto gap_at = [&](double t) {
    return gap(world, pair_of(1, 0), trajectory::along_arc(bodies[1], t),
               trajectory::along_arc(bodies[0], t));
  };
  EXPECT_NEAR(rate[0], (gap_at(h) - gap_at(-h)) / (2.0 * h), 1e-5);
  EXPECT_NEAR(rate[1], (gap_at(h) - 2.0 * gap_at(0.0) + gap_at(-h)) / (h * h), 1e-3);
}

// Catches a lever or a relative heading with the wrong sign, in either order of the two bodies.
TEST(ContactSeries, RateOfACornerOnAnEdgeIsThatOfTheGap) {
  const collision::StaticWorld world =
      collision::make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  const double reach = 0.5 * world.parameters.robot_side + world.robot_outline.radius;
  const Heading corner_on = Heading::from_angle(0.25 * 3.14159265358979323846 + 0.1);
  for (const int corner : {0, 1}) {
    std::array<BodyState, 2> bodies;
    const double side = corner == 1 ? 1.0 : -1.0;
    bodies[1 - corner] = {{0.0, 0.0}, Heading{}, {0.2, 0.0, 1.5}};
    bodies[corner] = {{side * (reach - 3e-4), 0.005}, corner_on, {-0.1, 0.3, -2.0}};
    expect_rates_of_the_gap(world, bodies);
  }
}

// Catches a normal on a corner that turns with the robot instead of with the ball around the
// corner.
TEST(ContactSeries, RateOfTheBallOnACornerIsThatOfTheGap) {
  const collision::StaticWorld world =
      collision::make_static_world(nullptr, Parameters{}, Tolerances{}, 1, true);
  const double half = 0.5 * world.parameters.robot_side;
  const double radius = world.parameters.ball_radius;
  // The velocity of the corner, and one along the tangent: the gap stays zero in first order, which
  // term 1 assumes.
  const Vec2 place{half + 0.6 * radius, half + 0.8 * radius};
  const Vec2 velocity{0.2 - 1.5 * half - 0.4, 1.5 * half + 0.3};
  expect_rates_of_the_gap(world, {BodyState{{0.0, 0.0}, Heading{}, {0.2, 0.0, 1.5}},
                                  BodyState{place, Heading{}, {velocity.x(), velocity.y(), 0.0}}});
}

}  // namespace
}  // namespace mirocup::simulator::resting_contact
