// SPDX-License-Identifier: MIT
//
// A team whose wheel speeds are not numbers, or beyond every limit.
#include "tests/support/test_team.hpp"

#include <limits>

void TestTeam::decide(const Observation&, Command& command) {
  using Limits = std::numeric_limits<double>;
  command.wheels[0] = {Limits::quiet_NaN(), Limits::infinity()};
  command.wheels[1] = {-1e300, 1e300};
}
