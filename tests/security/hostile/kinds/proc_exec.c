/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  char* const arguments[] = {"/bin/sh", "-c", "echo >" MIROCUP_TARGET "/dropped", 0};
  execv(arguments[0], arguments);
}
