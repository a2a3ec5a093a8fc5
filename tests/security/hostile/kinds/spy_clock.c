/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* The processor time of the server, whose number T2 hides. */
  const long process = getppid() != 0 ? getppid() : 2;
  const long clock = (long)((~(unsigned)process << 3 | 2) | 1ul << 40);
  struct timespec time;
  if (syscall(SYS_clock_gettime, clock, &time) == 0) got_through("the clock of another process");
}
