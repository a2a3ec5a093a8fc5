/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void go_on(int number) {
  (void)number;
}

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Catches its own crashes and goes on for ever. */
  signal(SIGSEGV, go_on);
  *(volatile int*)hostile_nowhere = 1;
}
