/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  char attributes[64] = {0};
  syscall(SYS_bpf, 0, attributes, sizeof attributes);
}
