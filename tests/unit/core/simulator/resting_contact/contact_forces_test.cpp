// SPDX-License-Identifier: MIT
//
// Forces of resting contacts against Newton's laws.
#include "core/simulator/resting_contact/contact_forces.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mirocup::simulator::resting_contact {
namespace {

// Two robots at rest, side on side, the first behind the second; both contacts of the pair.
struct TwoInARow {
  Parameters p;
  collision::StaticWorld world =
      collision::make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  std::array<BodyState, 2> bodies{BodyState{{0.0, 0.0}, Heading{}, {}},
                                  BodyState{{Parameters{}.robot_side, 0.0}, Heading{}, {}}};
  collision::ContactList list;

  TwoInARow() { add_contacts(world, pair_of(1, 0), bodies, 1e-9, list); }

  // The sum of the forces when the motors have these wheel speeds as references.
  double force(double first, double second) {
    const std::array drives{trajectory::drive_reference(p, WheelSpeeds{first, first}),
                            trajectory::drive_reference(p, WheelSpeeds{second, second})};
    ContactForces forces(world);
    forces.decide(drives, bodies, list.contacts());
    double sum = 0.0;
    for (const collision::Contact& c : list.contacts()) sum += c.resting.force;
    return sum;
  }
};

// A robot that stands is pushed by one whose motors accelerate it: the force is half of what the
// motors' difference of accelerations times the mass is. Catches a wrong mass, factor or sign.
TEST(ContactForces, PushingRobotSharesItsAccelerationWithTheOther) {
  TwoInARow row;
  ASSERT_EQ(row.list.count, 2);
  const double acceleration = row.p.speed_reference(20.0, 20.0) / row.p.motor_time_constant;
  EXPECT_NEAR(row.force(20.0, 0.0), 0.5 * row.p.robot_mass * acceleration, 1e-9);
}

// Catches contacts that pull.
TEST(ContactForces, ContactThatOpensHasNoForce) {
  TwoInARow row;
  EXPECT_EQ(row.force(0.0, 20.0), 0.0);
  for (const collision::Contact& c : row.list.contacts()) EXPECT_FALSE(c.resting.is_active);
}

// Two robots approach each other by a speed below the restitution threshold. The projection gives
// both the common speed. Catches a projection that changes the momentum, or one body only.
TEST(ContactForces, ProjectionKeepsMomentumAndAddsNoEnergy) {
  TwoInARow row;
  row.bodies[0].twist.forward = 1e-5;
  for (collision::Contact& c : row.list.contacts()) c.impact.restitution_threshold = 1e-3;
  row.force(20.0, 0.0);
  EXPECT_NEAR(row.bodies[0].twist.forward, 5e-6, 1e-15);
  EXPECT_NEAR(row.bodies[1].twist.forward, 5e-6, 1e-15);
}

// A ball at rest that is pushed by a force below its rolling resistance stays. Catches resistance
// that is felt only by a rolling ball.
TEST(ContactForces, BallAtRestHoldsAgainstAPushBelowItsRollingResistance) {
  Parameters p;
  const collision::StaticWorld world =
      collision::make_static_world(nullptr, p, Tolerances{}, 1, true);
  const double reach = 0.5 * p.robot_side + p.ball_radius;
  std::array<BodyState, 2> bodies{BodyState{{0.0, 0.0}, Heading{}, {}},
                                  BodyState{{reach, 0.0}, Heading{}, {}}};
  collision::ContactList list;
  add_contacts(world, pair_of(1, 0), bodies, 1e-9, list);
  ASSERT_EQ(list.count, 1);
  ContactForces forces(world);
  const double resistance = p.rolling_resistance * p.ball_mass * gravity;
  for (const double share : {0.5, 2.0}) {
    // An acceleration at which the ball, without resistance, is pushed by this share of it.
    const double ball_mass = p.effective_ball_mass();
    const double acceleration =
        share * resistance * (p.robot_mass + ball_mass) / (p.robot_mass * ball_mass);
    const double wheels = acceleration * p.motor_time_constant / p.speed_reference(1.0, 1.0);
    const std::array drives{trajectory::drive_reference(p, WheelSpeeds{wheels, wheels})};
    forces.decide(drives, bodies, list.contacts());
    EXPECT_EQ(forces.grounding(1).push.norm() > 0.0, share > 1.0) << share;
  }
}

// A robot with its face to a wall that its motors press on, and its slip to the left.
struct AtAWall {
  Parameters p;
  field::Field field = field::make_field(RobotLeague::small);
  collision::StaticWorld world;
  std::array<BodyState, 1> bodies;
  collision::ContactList list;

  explicit AtAWall(double slip) {
    p.contact_friction.robot_wall = 0.3;
    world = collision::make_static_world(&field, p, Tolerances{}, 1, false);
    bodies[0] = {{0.1, field.half_width - 0.5 * p.robot_side}, Heading{0.0, 1.0}, {0.0, slip, 0.0}};
    for (int wall = 0; wall < static_cast<int>(field.walls.size()); ++wall)
      add_contacts(world, pair_with_obstacle(0, wall), bodies, 1e-9, list);
  }

  bool decide(double wheels) {
    const std::array drives{trajectory::drive_reference(p, WheelSpeeds{wheels, wheels})};
    return ContactForces(world).decide(drives, bodies, list.contacts());
  }
};

// Catches friction along the slide, and one of a contact that sticks: it has no constant direction.
TEST(ContactForces, FrictionIsDecidedWhereContactsSlide) {
  for (const double slip : {0.2, -0.2}) {
    AtAWall robot(slip);
    ASSERT_EQ(robot.list.count, 2);
    ASSERT_TRUE(robot.decide(20.0));
    for (const collision::Contact& c : robot.list.contacts()) {
      const double along = cross(1.0, c.point.normal).dot(robot.bodies[0].velocity());
      EXPECT_EQ(c.resting.friction, along > 0.0 ? -0.3 : 0.3);
    }
  }
  EXPECT_FALSE(AtAWall(0.0).decide(20.0));
}

}  // namespace
}  // namespace mirocup::simulator::resting_contact
