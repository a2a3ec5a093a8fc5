/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Everything below the observation, the answers among it. */
  volatile char* page = (volatile char*)((uintptr_t)hostile_now & ~(uintptr_t)4095);
  for (long i = 1; i < 1l << 40; ++i) page[-i] = 0x55;
}
