/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  volatile double zero = 0.0;
  for (int i = 0; i < MIROCUP_MAX_ROBOTS; ++i) {
    command->wheels[i].left = zero / zero;
    command->wheels[i].right = 1.0 / zero;
  }
}
