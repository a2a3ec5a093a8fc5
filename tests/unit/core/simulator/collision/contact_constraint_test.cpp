// SPDX-License-Identifier: MIT
//
// Rows of contacts, held against moved bodies and against Newton's laws.
#include "core/simulator/collision/contact_constraint.hpp"

#include "core/base/random.hpp"
#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace mirocup::simulator::collision {
namespace {

struct Touching2 {
  StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  std::array<BodyState, 2> bodies;
  std::unique_ptr<ContactList> list = std::make_unique<ContactList>();

  // Robot 1 has a corner 1 mm in front of an edge of robot 0.
  explicit Touching2(Random& random) {
    const double angle = random.uniform(-pi, pi);
    bodies[0] = {{0.1, -0.2}, Heading::from_angle(angle), random_twist(random)};
    const double distance = world.parameters.robot_side / 2.0 + world.robot_outline.radius + 1e-3;
    bodies[1] = {bodies[0].position + bodies[0].heading.to_world({distance, 0.01}),
                 Heading::from_angle(angle + 0.25 * pi), random_twist(random)};
    add_contacts(world, pair_of(0, 1), bodies, 2e-3, *list);
  }
  static Twist random_twist(Random& random) {
    return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-9.0, 9.0)};
  }
};

// Catches a wrong sign, a wrong lever or a wrong frame in a row.
TEST(ContactRow, RateIsTheDerivativeOfTheGap) {
  constexpr double h = 1e-6;  // s
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Touching2 two(random);
    ASSERT_EQ(two.list->count, 1);
    const auto gap_after = [&](double span) {
      return gap(two.world, pair_of(0, 1), trajectory::along_arc(two.bodies[1], span),
                 trajectory::along_arc(two.bodies[0], span));
    };
    const double slope = (gap_after(h) - gap_after(-h)) / (2.0 * h);
    EXPECT_NEAR(row_rate(two.list->list[0].row, two.bodies), slope, 1e-8) << i;
  }
}

// Catches an impulse that acts on one body only, or beside the contact.
TEST(ContactImpulse, KeepsMomentumAndAngularMomentum) {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    Touching2 two(random);
    const Parameters& p = two.world.parameters;
    const std::array<solver::InverseMass, 2> mass{two.world.free_robot, two.world.free_robot};
    const auto momenta = [&] {
      Vec2 linear{0.0, 0.0};
      double angular = 0.0;
      for (const BodyState& body : two.bodies) {
        const Vec2 momentum = p.robot_mass * body.velocity();
        linear += momentum;
        angular += cross(body.position, momentum) + p.robot_inertia() * body.twist.omega;
      }
      return std::array<double, 3>{linear.x(), linear.y(), angular};
    };
    const solver::ConstraintRow& row = two.list->list[0].row;
    const auto before = momenta();
    const double rate = row_rate(row, two.bodies);
    apply_impulse(row, 0.05, mass, two.bodies);
    const auto after = momenta();
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-14);
    EXPECT_NEAR(row_rate(row, two.bodies) - rate, 0.05 * inverse_effective_mass(row, mass), 1e-12);
  }
}

// Two spheres, or here a ball on the middle of an edge, have the reduced mass. Catches a ball whose
// rolling is forgotten: its mass is 7/5 of its own.
TEST(ContactRow, EffectiveMassOfACentralContactIsTheReducedMass) {
  const StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 1, true);
  const Parameters& p = world.parameters;
  const std::array<BodyState, 2> bodies{
      BodyState{}, BodyState{{p.robot_side / 2.0 + p.ball_radius, 0.0}, Heading{}, {}}};
  const std::array<solver::InverseMass, 2> mass{world.free_robot, world.ball};
  const auto list = std::make_unique<ContactList>();
  add_contacts(world, pair_of(0, 1), bodies, 1e-9, *list);
  ASSERT_EQ(list->count, 1);
  EXPECT_NEAR(inverse_effective_mass(list->list[0].row, mass),
              1.0 / p.robot_mass + 5.0 / (7.0 * p.ball_mass), 1e-12);
}

TEST(ContactList, CountsWhatFindsNoRoom) {
  const StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  const std::array<BodyState, 2> bodies{
      BodyState{}, BodyState{{world.parameters.robot_side, 0.0}, Heading{}, {}}};
  const auto list = std::make_unique<ContactList>();
  while (!list->full()) add_contacts(world, pair_of(0, 1), bodies, 1e-9, *list);
  list->overflows = 0;
  add_contacts(world, pair_of(0, 1), bodies, 1e-9, *list);
  EXPECT_EQ(list->count, max_contacts);
  EXPECT_EQ(list->overflows, 2);
}

TEST(ContactList, KeepsTheOrderOfTheContactsThatStay) {
  const auto list = std::make_unique<ContactList>();
  for (int i = 0; i < 6; ++i) list->list[list->count++].pair = {i + 1, 0};
  list->keep_if([](const Contact& c) { return c.pair.a % 2 == 0; });
  ASSERT_EQ(list->count, 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(list->list[i].pair.a, 2 * (i + 1));
}

}  // namespace
}  // namespace mirocup::simulator::collision
