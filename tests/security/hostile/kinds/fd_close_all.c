/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int fd = 0; fd < 1024; ++fd) close(fd);
}
