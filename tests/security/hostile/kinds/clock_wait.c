/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  /* Until a time that never comes on the clocks that a team sees. */
  const struct timespec never = {1ll << 40, 0};
  (void)command;
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &never, 0);
}
