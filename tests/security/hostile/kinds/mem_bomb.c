/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (long i = 0; i < 4096; ++i) {
    volatile char* block = malloc(1 << 20);
    if (block == 0) return;
    for (int k = 0; k < 1 << 20; k += 4096) block[k] = 1;
  }
  got_through("4 GiB");
}
