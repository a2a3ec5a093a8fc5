/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  volatile char* block = malloc(2 << 20);
  if (block == 0) return;
  for (int k = 0; k < 2 << 20; k += 4096) block[k] = 1;
}
