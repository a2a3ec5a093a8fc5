/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* If this were allowed, it would look like a kill by the host. */
  syscall(SYS_tgkill, getpid(), syscall(SYS_gettid), SIGKILL);
}
