// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <vector>

static void misbehave(mirocup_command*) {
  const std::vector<double> much(std::size_t{1} << 34);
  asm volatile("" : : "r"(much.data()) : "memory");  // keeps the compiler from removing it
  hostile_for_ever = much.empty() ? 1 : 2;
}
