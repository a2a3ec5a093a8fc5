/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  if (getsid(0) < 0 || getpgid(getpid()) < 0) raise(SIGABRT); /* its own may be asked for */
  if (getsid(getppid() != 0 ? getppid() : 2) >= 0) got_through("the session of another process");
}
