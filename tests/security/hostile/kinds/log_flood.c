/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int i = 0; i < 1000; ++i) fprintf(stderr, "a line that nobody asked for, %d\n", i);
}
