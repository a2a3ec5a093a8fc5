// SPDX-License-Identifier: MIT
//
// A team that dies in tick 40.
#include "tests/support/test_team.hpp"

#include <cstdlib>

void TestTeam::decide(const Observation& now, Command&) {
  if (now.tick >= 40) std::abort();
}
