/* SPDX-License-Identifier: MIT */
#include "tests/hostile/hostile.h"

/* Where the compiler cannot see that nothing is. */
static volatile uintptr_t nowhere = 16;

static void misbehave(mirocup_command* command) {
  (void)command;
  *(volatile int*)nowhere = 1;
}
