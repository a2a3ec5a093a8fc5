// SPDX-License-Identifier: MIT
//
// A robot alone against the integrator in extended precision. Catches a wrong sign in the
// equations of motion, and wheels that begin or cease to slide at the wrong time.
#include "core/simulator/trajectory/differential_drive.hpp"

#include "core/base/math.hpp"
#include "tests/support/exact_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

// Drives for `duration` seconds, segment by segment.
BodyState driven(const Parameters& p, BodyState robot, const WheelCommand& command,
                 double duration) {
  const DriveReference reference = drive_reference(p, command);
  double t = 0.0;
  for (int i = 0; i < 1000 && t < duration; ++i) {
    const Segment s = drive(p, robot, reference, t, duration, never);
    robot = body_at(s, s.end);
    t = s.end;
  }
  EXPECT_EQ(t, duration);
  return robot;
}

void expect_exact(const BodyState& robot, const WheelCommand& command) {
  const Parameters p;
  const BodyState end = driven(p, robot, command, 0.2);
  const BodyState exact = test_support::rounded(
      test_support::drive_exactly(p, test_support::exactly(robot), command, 0.2L));
  EXPECT_NEAR((end.position - exact.position).norm(), 0.0, 1e-9);
  EXPECT_NEAR(end.heading.cos, exact.heading.cos, 1e-9);
  EXPECT_NEAR(end.twist.forward, exact.twist.forward, 1e-9);
  EXPECT_NEAR(end.twist.left, exact.twist.left, 1e-8);
}

TEST(DifferentialDrive, RollingRobotFollowsTheEquations) {
  expect_exact({{0.0, 0.0}, Heading::from_angle(0.3), {0.4, 0.0, 2.0}}, WheelSpeeds{30.0, 10.0});
}

TEST(DifferentialDrive, SlidingRobotFollowsTheEquationsAndGripsAgain) {
  expect_exact({{0.0, 0.0}, Heading::from_angle(0.3), {0.4, 0.5, 2.0}}, WheelSpeeds{30.0, 10.0});
}

TEST(DifferentialDrive, LiftedRobotKeepsItsVelocityInTheField) {
  const BodyState robot{{0.0, 0.0}, Heading::from_angle(0.3), {0.4, 0.5, 6.0}};
  const BodyState end = driven(Parameters{}, robot, WheelCommand{}, 0.1);
  EXPECT_NEAR((end.velocity() - robot.velocity()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((end.position - 0.1 * robot.velocity()).norm(), 0.0, 1e-12);
}

TEST(DifferentialDrive, CommandsAreClampedToTheWheelSpeedLimit) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(drive_reference(p, WheelSpeeds{200.0, 200.0}).forward,
                   p.wheel_radius * p.wheel_speed_limit);
  EXPECT_DOUBLE_EQ(drive_reference(p, WheelSpeeds{-200.0, 200.0}).omega,
                   2.0 * p.wheel_radius * p.wheel_speed_limit / p.wheel_distance);
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
