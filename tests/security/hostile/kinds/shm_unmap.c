/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  const uintptr_t page = (uintptr_t)hostile_now & ~(uintptr_t)4095;
  munmap((void*)(page - 4096), 8192);
}
