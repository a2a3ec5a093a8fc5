/* SPDX-License-Identifier: MIT */
#include "tests/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  volatile int for_ever = 1;
  (void)command;
  while (for_ever) {
  }
}
