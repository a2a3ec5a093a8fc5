/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  ((mirocup_observation*)(uintptr_t)hostile_now)->own_score = 99;
}
