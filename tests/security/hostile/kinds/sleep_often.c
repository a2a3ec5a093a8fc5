/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  /* Would make a leg last for hours. */
  const struct timespec two_seconds = {2, 200000000};
  (void)command;
  nanosleep(&two_seconds, 0);
}
