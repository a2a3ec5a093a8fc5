/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sched.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  unshare(CLONE_NEWUSER | CLONE_NEWNS);
}
