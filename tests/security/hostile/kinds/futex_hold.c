/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Waits on a futex, as the server does, for a wake-up that never comes. */
  static int word;
  while (hostile_for_ever) syscall(SYS_futex, &word, 0, 0, 0, 0, 0);
}
