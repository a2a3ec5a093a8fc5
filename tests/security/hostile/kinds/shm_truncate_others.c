/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* By a number that belongs to the server, if anything of it is left. */
  expect_failure(syscall(SYS_fcntl, 3, F_GET_SEALS), "descriptor 3");
}
