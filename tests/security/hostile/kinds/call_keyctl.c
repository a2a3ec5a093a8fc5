/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  syscall(SYS_keyctl, 0, 0, 0, 0, 0);
}
