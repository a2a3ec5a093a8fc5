/* SPDX-License-Identifier: MIT */
#define HOSTILE_PLACE place
#include "tests/security/hostile/hostile.h"

BEHAVES_LATER

static void place(void* team, const mirocup_observation* now, mirocup_placement* placement) {
  (void)team, (void)now, (void)placement;
  *(volatile int*)hostile_nowhere = 1;
}
