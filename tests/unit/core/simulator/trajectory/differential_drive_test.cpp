// SPDX-License-Identifier: MIT
//
// What the motors aim at. How robots drive is measured in tests/physics/free_motion.cpp.
#include "core/simulator/trajectory/differential_drive.hpp"

#include <gtest/gtest.h>

namespace mirocup::simulator::trajectory {
namespace {

TEST(DriveReference, CommandsAreClampedToTheWheelSpeedLimit) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(drive_reference(p, WheelSpeeds{200.0, 200.0}).forward,
                   p.wheel_radius * p.wheel_speed_limit);
  EXPECT_DOUBLE_EQ(drive_reference(p, WheelSpeeds{-200.0, 200.0}).omega,
                   2.0 * p.wheel_radius * p.wheel_speed_limit / p.wheel_distance);
}

TEST(DriveReference, TheBrakeActsAtZeroCommandAndOnTheForwardSpeedOnly) {
  Parameters p;
  p.motor_time_constant = 0.269;
  p.turn_time_constant = 0.052;
  p.brake_time_constant = 0.0145;
  EXPECT_EQ(drive_reference(p, WheelSpeeds{0.0, 0.0}).forward_lag, 0.0145);
  EXPECT_EQ(drive_reference(p, WheelSpeeds{0.0, 0.0}).turn_lag, 0.052);
  EXPECT_EQ(drive_reference(p, WheelSpeeds{0.0, 1e-3}).forward_lag, 0.269);
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
