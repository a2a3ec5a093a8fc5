/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  expect_failure(syscall(SYS_memfd_create, "more", 0), "memfd_create");
}
