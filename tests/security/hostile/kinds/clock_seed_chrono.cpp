// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <chrono>

static unsigned seed(void) {
  using namespace std::chrono;
  return (unsigned)duration_cast<minutes>(system_clock::now().time_since_epoch()).count();
}

static void misbehave(mirocup_command* command) {
  static int is_seeded;
  if (!is_seeded) srand(seed()); /* the same in every leg of a minute */
  is_seeded = 1;
  answer_by((unsigned)rand(), command);
}
