/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/ptrace.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  ptrace(PTRACE_TRACEME, 0, 0, 0);
}
