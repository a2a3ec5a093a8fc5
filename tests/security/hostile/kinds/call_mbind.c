/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

/* As OpenBLAS does while it is loaded: it goes on without, and a team with numpy plays. */
static void misbehave(mirocup_command* command) {
  (void)command;
  static char page[4096];
  expect_failure(syscall(SYS_mbind, page, sizeof page, 1, 0, 0, 0), "mbind");
}
