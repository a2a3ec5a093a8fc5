// SPDX-License-Identifier: MIT
#include "core/simulator/impact/wheel_stiction.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup::simulator::impact {
namespace {

// Two robots at the origin and at x = 0.075 m, which touch in the middle between them.
struct Side {
  Parameters parameters;
  std::array<BodyState, 2> bodies;
  std::array<solver::InverseMass, 2> mass;
  std::array<collision::Contact, 1> contacts;
  solver::BoxQp problem;

  Side() {
    bodies[1].position = {0.075, 0.0};
    mass.fill(collision::free_robot_mass(parameters));
    collision::Contact& c = contacts[0];
    c.pair = pair_of(0, 1);
    c.a = 1;
    c.b = 0;
    c.point.point = {0.0375, 0.0};
    c.point.normal = {1.0, 0.0};
    set_row(bodies, c);
  }
  void stop(int robot, double max_impulse) {
    arrest_slip(contacts, std::array{robot}, max_impulse, mass, bodies, problem);
  }
};

TEST(WheelStiction, ImpulseOfTheGroundIsBounded) {
  Side side;
  const double m = side.parameters.robot_mass;
  side.bodies[1].twist.left = 1e-4;
  side.stop(1, 2e-4 * m);
  EXPECT_EQ(side.bodies[1].twist.left, 0.0);

  side.bodies[1].twist.left = 1e-4;
  side.stop(1, 0.25e-4 * m);
  EXPECT_NEAR(side.bodies[1].twist.left, 0.75e-4, 1e-18);
}

// Wheels that are stopped must not drive a robot into another one: the contact pushes back.
TEST(WheelStiction, LetsNoContactApproach) {
  Side side;
  side.bodies[1].heading = Heading{0.0, 1.0};  // its left is -x, towards the first one
  set_row(side.bodies, side.contacts[0]);
  side.bodies[0].twist.forward = 1e-4;
  side.bodies[1].twist.left = -1e-4;  // away from the first one, as fast as that follows
  side.stop(1, 1e-3);
  EXPECT_GE(collision::row_rate(side.contacts[0].row, side.bodies), -1e-15);
  EXPECT_GE(side.contacts[0].impact.impulse, 0.0);
}

}  // namespace
}  // namespace mirocup::simulator::impact
