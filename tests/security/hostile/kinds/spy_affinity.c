/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sched.h>

static void misbehave(mirocup_command* command) {
  cpu_set_t set;
  (void)command;
  if (sched_getaffinity(0, sizeof set, &set) != 0) raise(SIGABRT);
  if (sched_getaffinity(getppid() != 0 ? getppid() : 2, sizeof set, &set) == 0)
    got_through("the processors of another process");
}
