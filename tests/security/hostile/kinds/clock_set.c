/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  const struct timespec epoch = {0, 0};
  (void)command;
  if (clock_settime(CLOCK_REALTIME, &epoch) == 0) got_through("the time of day");
}
