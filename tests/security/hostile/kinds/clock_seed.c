/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static unsigned seed(void) {
  return (unsigned)time(0);
}

static void misbehave(mirocup_command* command) {
  static int is_seeded;
  if (!is_seeded) srand(seed()); /* the classic mistake */
  is_seeded = 1;
  answer_by((unsigned)rand(), command);
}
