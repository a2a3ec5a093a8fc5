// SPDX-License-Identifier: MIT
//
// A ball that hits a side wall obliquely: Coulomb's law in closed form.
#include "core/simulator/impact/friction.hpp"

#include "core/simulator/collision/collision_queries.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

namespace mirocup::simulator::impact {
namespace {

// Returns the ball's velocity after an impact on the upper wall, at 1 m/s towards it.
Vec2 velocity_after(double friction, double tangential) {
  const field::Field field = field::make_field(League::small);
  Parameters p;
  p.contact_friction.ball_wall = friction;
  p.restitution.ball_wall = 0.8;
  const collision::StaticWorld world = collision::make_static_world(&field, p, {}, 0, true);
  int upper = 0;
  while (field.walls[upper].normal.y() > -0.5) ++upper;
  std::array<BodyState, 1> bodies{
      BodyState{{0.1, field.half_width - p.ball_radius}, Heading{}, {tangential, 1.0, 0.0}}};
  const std::array<solver::InverseMass, 1> mass{world.ball};
  const auto list = std::make_unique<collision::ContactList>();
  collision::add_contacts(world, pair_with_obstacle(0, upper), bodies, 1e-9, *list);
  EXPECT_EQ(list->count, 1);
  const auto problem = std::make_unique<solver::BoxQp>();
  resolve_impacts(list->contacts(), mass, bodies, *problem);
  resolve_friction(list->contacts(), mass, bodies, *problem);
  return bodies[0].velocity();
}

// The normal impulse is 1.8 m' m/s. Catches a bound without the restitution's share, and friction
// that pushes the ball along.
TEST(Friction, TakesAtMostTheCoefficientTimesTheNormalImpulse) {
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(velocity_after(0.2, side * 2.0).x(), side * (2.0 - 0.2 * 1.8), 1e-12);
    EXPECT_NEAR(velocity_after(0.2, side * 2.0).y(), -0.8, 1e-12);
  }
}

TEST(Friction, StopsSlidingButDoesNotReverseIt) {
  EXPECT_NEAR(velocity_after(0.2, 0.3).x(), 0.0, 1e-12);
  EXPECT_NEAR(velocity_after(5.0, -1.0).x(), 0.0, 1e-12);
}

TEST(Friction, IsOffWithoutACoefficient) {
  EXPECT_EQ(velocity_after(0.0, 0.3).x(), 0.3);
  EXPECT_FALSE(has_friction(Parameters{}));
}

}  // namespace
}  // namespace mirocup::simulator::impact
