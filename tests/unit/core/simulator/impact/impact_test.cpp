// SPDX-License-Identifier: MIT
//
// Impacts, held against closed forms and conservation laws.
#include "core/simulator/impact/impact.hpp"

#include "core/base/random.hpp"
#include "core/simulator/collision/collision_queries.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace mirocup::simulator::impact {
namespace {

// Free robots in a row along x that touch side by side.
struct Row {
  collision::StaticWorld world;
  std::vector<BodyState> bodies;
  std::vector<solver::InverseMass> mass;
  std::unique_ptr<collision::ContactList> list = std::make_unique<collision::ContactList>();
  std::unique_ptr<solver::BoxQp> problem = std::make_unique<solver::BoxQp>();

  Row(int robots, double restitution)
      : world(collision::make_static_world(nullptr, parameters(restitution), {}, robots, false)) {
    for (int i = 0; i < robots; ++i) {
      bodies.emplace_back(Vec2{i * world.parameters.robot_side, 0.0}, Heading{}, Twist{});
      mass.push_back(world.free_robot);
    }
    for (int i = 1; i < robots; ++i) {
      collision::add_contacts(world, pair_of(i, i - 1), bodies, 1e-9, *list);
    }
  }
  static Parameters parameters(double restitution) {
    Parameters p;
    p.restitution.robot_robot = restitution;
    return p;
  }
  void resolve() { resolve_impacts(list->contacts(), mass, bodies, *problem); }

  double energy() const {
    double sum = 0.0;
    for (const BodyState& b : bodies) {
      sum += 0.5 * world.parameters.robot_mass * b.velocity().squaredNorm() +
             0.5 * world.parameters.robot_inertia() * b.twist.omega * b.twist.omega;
    }
    return sum;
  }
  Vec2 momentum() const {
    Vec2 sum{0.0, 0.0};
    for (const BodyState& b : bodies) sum += world.parameters.robot_mass * b.velocity();
    return sum;
  }
};

// A row of which the first is hit while the others press: the rate of a contact that presses is
// zero up to rounding. Catches an impact whose impulses depend on the sign of that rounding.
TEST(Impact, RoundingOfAContactThatPressesDoesNotMatter) {
  const auto last_of = [](double rate) {
    Row row(3, 0.3);
    row.bodies[0].twist.forward = 0.5;
    row.bodies[2].twist.forward = rate;
    row.resolve();
    return row.bodies[2].twist.forward;
  };
  EXPECT_NEAR(last_of(1e-11), last_of(-1e-11), 1e-9);
}

// A symmetric impact stays symmetric. Catches contacts that are resolved one after the other.
TEST(Impact, TheMiddleOfASymmetricImpactStaysAtRest) {
  Row row(3, 0.6);
  row.bodies[0].twist.forward = 0.5;
  row.bodies[2].twist.forward = -0.5;
  row.resolve();
  EXPECT_NEAR(row.bodies[1].twist.forward, 0.0, 1e-12);
  EXPECT_NEAR(row.bodies[0].twist.forward, -row.bodies[2].twist.forward, 1e-12);
}

TEST(Impact, SlowApproachDoesNotBounce) {
  Row row(2, 0.6);
  for (collision::Contact& c : row.list->contacts()) c.impact.restitution_threshold = 1e-3;
  row.bodies[0].twist.forward = 0.9e-3;
  row.resolve();
  EXPECT_NEAR(row.bodies[0].twist.forward, 0.45e-3, 1e-15);
  EXPECT_NEAR(row.bodies[1].twist.forward, 0.45e-3, 1e-15);
}

// With different e a round may add energy, if it is not done again with the smallest of them.
TEST(Impact, KeepsMomentumAndNeverAddsEnergy) {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    Row row(4, 0.0);
    for (collision::Contact& c : row.list->contacts()) {
      c.material.restitution = random.coin() ? 1.0 : 0.0;
    }
    for (BodyState& b : row.bodies) {
      b.twist = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-9.0, 9.0)};
    }
    const double energy = row.energy();
    const Vec2 momentum = row.momentum();
    row.resolve();
    ASSERT_LE(row.energy(), energy * (1.0 + 1e-9)) << i;
    ASSERT_NEAR((row.momentum() - momentum).norm(), 0.0, 1e-10) << i;
    for (const collision::Contact& c : row.list->contacts()) {
      ASSERT_GE(collision::row_rate(c.row, row.bodies), -1e-7) << i;
      ASSERT_GE(c.impact.impulse, -1e-12) << i;
    }
  }
}

}  // namespace
}  // namespace mirocup::simulator::impact
