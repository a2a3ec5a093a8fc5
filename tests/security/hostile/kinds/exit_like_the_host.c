/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* The code with which the sandbox itself gives up: must not make the leg void. */
  _exit(127);
}
