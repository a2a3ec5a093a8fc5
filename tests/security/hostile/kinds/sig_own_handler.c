/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  if (signal(SIGSYS, SIG_IGN) != SIG_ERR) got_through("the signal of the filter");
  kill(1, 0);
}
