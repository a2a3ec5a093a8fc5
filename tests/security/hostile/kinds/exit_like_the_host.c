/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* The exit code of a failed sandbox. A team that uses it must not make the leg void. */
  _exit(127);
}
