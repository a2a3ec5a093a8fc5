/* SPDX-License-Identifier: MIT */
#define HOSTILE_CREATE create
#include "tests/security/hostile/hostile.h"

BEHAVES_LATER

static void* create(const mirocup_setup* setup) {
  (void)setup;
  *(volatile int*)hostile_nowhere = 1;
  return 0;
}
