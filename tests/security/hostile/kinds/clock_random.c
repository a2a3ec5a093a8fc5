/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  command->wheels[0].left = (double)(now.tv_nsec % 50000) / 1000.0; /* hardly ever the same twice */
}
