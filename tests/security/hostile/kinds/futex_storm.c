/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  const uintptr_t page = (uintptr_t)hostile_now & ~(uintptr_t)4095;
  for (int i = 0; i < 1000; ++i) syscall(SYS_futex, page - 4096, 1, 1000, 0, 0, 0);
}
