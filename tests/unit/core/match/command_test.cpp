// SPDX-License-Identifier: MIT
//
// Catches a bad value that is driven or not counted, and a rounding that a record does not hold.
#include "core/match/command.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace mirocup::match {
namespace {

Command first_robot(double left, double right) {
  Command command;
  command.wheels[0] = {left, right};
  return command;
}

TEST(CheckedCommands, SpeedsAreRoundedToTheStepOfTheRadio) {
  const CheckedCommand checked = check(first_robot(10.0, 0.6 * wheel_speed_step), 3, 80.0);
  EXPECT_EQ(checked.command.wheels[0][0], 2560);
  EXPECT_EQ(checked.command.wheels[0][1], 1);
  EXPECT_EQ(checked.command.speeds(0).left, 10.0);
  EXPECT_EQ(checked.bad_values, 0);
}

TEST(CheckedCommands, SpeedsOutOfRangeAreClampedAndCounted) {
  const CheckedCommand checked = check(first_robot(80.1, -1e300), 3, 80.0);
  EXPECT_EQ(checked.command.speeds(0).left, 80.0);
  EXPECT_EQ(checked.command.speeds(0).right, -80.0);
  EXPECT_EQ(checked.bad_values, 2);
}

TEST(CheckedCommands, InfiniteAndUndefinedSpeedsBecomeZero) {
  const double infinite = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const CheckedCommand checked = check(first_robot(infinite, not_a_number), 3, 80.0);
  EXPECT_EQ(checked.command, DrivenCommand{});
  EXPECT_EQ(checked.bad_values, 2);
}

TEST(CheckedCommands, RobotsBeyondTheTeamAreIgnored) {
  Command command;
  command.wheels[3] = {1e9, 1e9};
  const CheckedCommand checked = check(command, 3, max_wheel_speed);
  EXPECT_EQ(checked.command, DrivenCommand{});
  EXPECT_EQ(checked.bad_values, 0);
}

}  // namespace
}  // namespace mirocup::match
