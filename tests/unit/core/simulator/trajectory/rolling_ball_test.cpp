// SPDX-License-Identifier: MIT
//
// When a ball stops. How it rolls until then is measured in tests/physics/free_motion.cpp.
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator::trajectory {
namespace {

TEST(RollingBall, StoppingTimeWithoutViscousFrictionIsSpeedByDeceleration) {
  EXPECT_DOUBLE_EQ(stopping_time({.constant = 0.5, .linear = 0.0}, 2.0), 4.0);
  EXPECT_DOUBLE_EQ(stopping_time({.constant = 0.5, .linear = 0.1}, 2.0), std::log(1.4) / 0.1);
  EXPECT_EQ(stopping_time({.constant = 0.0, .linear = 0.1}, 2.0), never);
}

}  // namespace
}  // namespace mirocup::simulator::trajectory
