/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  /* Behind the end of the answer lies the host program's own stack. */
  for (int i = 0; i < 100000; ++i) ((volatile double*)command->wheels)[i] = 1.0;
}
