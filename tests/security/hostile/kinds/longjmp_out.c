/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <setjmp.h>

static jmp_buf nowhere_set;

static void misbehave(mirocup_command* command) {
  (void)command;
  longjmp(nowhere_set, 1);
}
