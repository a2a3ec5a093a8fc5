// SPDX-License-Identifier: MIT
#include "tests/support/test_team.hpp"

void TestTeam::decide(const Observation& now, Command& command) {
  // Built with -Ofast, which switches denormal numbers off for the process that loads it.
  const volatile double tiny = 1e-310;
  command.wheels[0] = {tiny * 1e305 > 1e-6 ? 20.0 : 10.0, 15.0};
  if (now.tick == 0) log("with -Ofast");
}
