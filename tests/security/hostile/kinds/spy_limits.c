/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/resource.h>

static void misbehave(mirocup_command* command) {
  struct rlimit limit;
  (void)command;
  if (prlimit(0, RLIMIT_AS, 0, &limit) != 0) raise(SIGABRT);
  if (prlimit(getppid() != 0 ? getppid() : 2, RLIMIT_AS, 0, &limit) == 0)
    got_through("the limits of another process");
}
