/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  if (getppid() > 0) kill(getppid(), SIGKILL);
}
