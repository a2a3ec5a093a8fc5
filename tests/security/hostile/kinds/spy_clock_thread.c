/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  struct timespec time;
  /* Only the existence of the clock: it tells whether a process lives. */
  if (syscall(SYS_clock_getres, (long)(int)(~4242u << 3 | 6), &time) == 0)
    got_through("the clock of another thread");
}
