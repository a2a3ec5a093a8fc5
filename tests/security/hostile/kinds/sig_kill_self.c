/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Looks as if the host had done it, were it allowed. */
  syscall(SYS_tgkill, getpid(), syscall(SYS_gettid), SIGKILL);
}
