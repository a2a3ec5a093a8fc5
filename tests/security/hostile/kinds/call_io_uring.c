/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  char parameters[120] = {0};
  syscall(SYS_io_uring_setup, 1, parameters);
}
