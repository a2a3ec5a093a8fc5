// SPDX-License-Identifier: MIT
//
// A team that drives in circles, logs "tick 2" when that tick comes, and sends its own process the
// signal ENDING at tick 30.
#pragma once

#include "tests/support/test_team.hpp"

#include <csignal>

void TestTeam::decide(const Observation& now, Command& command) {
  if (now.tick == 2) log("tick 2");
  if (now.tick == 30) raise(ENDING);
  for (int i = 0; i < now.robots; ++i) command.wheels[i] = {10.0, 20.0};
}
