/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int fd = 3; fd < 16; ++fd) (void)!ftruncate(fd, 0);
}
