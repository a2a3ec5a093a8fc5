// SPDX-License-Identifier: MIT
//
// Motion of contact clusters against closed forms.
#include "core/simulator/resting_contact/contact_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::simulator::resting_contact {
namespace {

constexpr double tick = 0.033;  // s

// Two robots in a row, side on side, that drive along it with these wheel speeds as references.
struct Row {
  Parameters p;
  collision::StaticWorld world =
      collision::make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  std::array<BodyState, 2> bodies{BodyState{{0.0, 0.0}, Heading{}, {}},
                                  BodyState{{Parameters{}.robot_side, 0.0}, Heading{}, {}}};
  std::array<trajectory::Segment, max_bodies> segments;
  collision::ContactList list;

  void move(double first, double second) {
    add_contacts(world, pair_of(1, 0), bodies, 1e-9, list);
    const std::array drives{trajectory::drive_reference(p, WheelSpeeds{first, first}),
                            trajectory::drive_reference(p, WheelSpeeds{second, second})};
    ContactForces forces(world);
    forces.decide(drives, bodies, list.contacts());
    ContactMotion motion(world);
    motion.move(BodySet(3), forces, list.contacts(), drives, {0.0, tick, tick, 1e-8}, bodies,
                segments);
  }
};

// The motors of both together follow the mean of the references with the motors' time constant.
// Catches wrong terms of the forces: they would let the gap open or close.
TEST(ContactMotion, PushedRobotFollowsTheClosedFormOfTheCommonSpeed) {
  Row row;
  row.move(30.0, 10.0);
  const double reference = 0.5 * row.p.speed_reference(40.0, 40.0);
  const double t = row.segments[0].end;
  ASSERT_GT(t, 1e-3);
  const double expected = -std::expm1(-t / row.p.motor_time_constant) * reference;
  for (const int i : {0, 1}) {
    const BodyState body = body_at(row.segments[i], t);
    EXPECT_NEAR(body.twist.forward, expected, 1e-9);
  }
  const double distance =
      body_at(row.segments[1], t).position.x() - body_at(row.segments[0], t).position.x();
  EXPECT_NEAR(distance, row.p.robot_side, 1e-12);
}

// Equal and opposite motors: catches a pile at rest that is computed again and again.
TEST(ContactMotion, ClusterAtRestGetsOneSegmentToTheHorizon) {
  Row row;
  row.move(20.0, -20.0);
  for (const int i : {0, 1}) {
    EXPECT_EQ(row.segments[i].end, tick);
    EXPECT_EQ(body_at(row.segments[i], tick).twist.forward, 0.0);
  }
}

// Catches segments of one cluster that end at different times: a member would be advanced alone.
TEST(ContactMotion, MembersOfAClusterShareTheEnd) {
  Row row;
  row.bodies[1].heading = Heading::from_angle(0.0);
  row.bodies[1].position.y() = 0.01;
  row.move(40.0, 0.0);
  EXPECT_EQ(row.segments[0].end, row.segments[1].end);
}

}  // namespace
}  // namespace mirocup::simulator::resting_contact
