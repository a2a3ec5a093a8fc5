/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  char arguments[88] = {0};
  expect_failure(syscall(SYS_clone3, arguments, sizeof arguments), "clone3");
}
