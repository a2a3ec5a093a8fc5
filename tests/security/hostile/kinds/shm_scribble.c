/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Overwrites all memory below the observation, the answers included. */
  volatile char* page = (volatile char*)((uintptr_t)hostile_now & ~(uintptr_t)4095);
  for (long i = 1; i < 1l << 40; ++i) page[-i] = 0x55;
}
