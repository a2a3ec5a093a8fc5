// SPDX-License-Identifier: MIT
#include "tests/support/test_team.hpp"

#include <cfenv>

namespace {

__attribute__((constructor)) void at_load() {
  std::fesetround(FE_DOWNWARD);
}

}  // namespace

void TestTeam::decide(const Observation& now, Command& command) {
  std::fesetround(now.tick % 2 == 0 ? FE_UPWARD : FE_TOWARDZERO);
  command.wheels[0] = {20.0, 15.0 + 0.01 * (now.tick % 100)};
  if (now.tick == 0) setup().log(setup().host, "with rounding of its own");
#if defined(__x86_64__)
  asm volatile("fldpi\n\tfldpi\n\tstd");  // leaves x87 stack and direction flag changed
#endif
}
