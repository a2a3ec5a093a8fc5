// SPDX-License-Identifier: MIT
//
// A team whose commands depend on the time of day from tick 40 on.
#include "tests/support/test_team.hpp"

#include <ctime>

void TestTeam::decide(const Observation& now, Command& command) {
  timespec time{};
  if (now.tick < 40) return;
  clock_gettime(CLOCK_REALTIME, &time);
  command.wheels[0].left = static_cast<double>(time.tv_nsec % 8192) / 256.0;
}
