// SPDX-License-Identifier: MIT
#include "tests/support/test_team.hpp"

extern "C" void team_decide(int32_t robots, double ball_x, double ball_y, double* wheels);

void TestTeam::decide(const Observation& now, Command& command) {
  team_decide(now.robots, now.ball_x, now.ball_y, &command.wheels[0].left);
  if (now.tick == 0) log("in Fortran");
}
