/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Tries the number of a descriptor of the server, in case the sandbox left it open. */
  expect_failure(syscall(SYS_fcntl, 3, F_GET_SEALS), "descriptor 3");
}
