/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  void* page = (void*)((uintptr_t)hostile_now & ~(uintptr_t)4095);
  expect_failure(mprotect(page, 4096, PROT_READ | PROT_WRITE), "a writable observation");
}
