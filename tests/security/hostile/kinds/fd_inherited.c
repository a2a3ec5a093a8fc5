/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int fd = 3; fd < 1024; ++fd) expect_failure(fcntl(fd, F_GETFD), "a descriptor");
}
