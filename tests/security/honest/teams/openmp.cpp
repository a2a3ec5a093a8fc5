// SPDX-License-Identifier: MIT
#include "tests/support/test_team.hpp"

#include <omp.h>
#include <vector>

void TestTeam::decide(const Observation& now, Command& command) {
  std::vector<double> values(10000);
#pragma omp parallel for
  for (int i = 0; i < 10000; ++i) values[static_cast<std::size_t>(i)] = 0.002 * i;
  command.wheels[0] = {values[9999], values[5000]};
  if (now.tick == 0) log("with OpenMP, %d thread", omp_get_max_threads());
}
