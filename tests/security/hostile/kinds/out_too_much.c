/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  /* Writes behind the end of the answer, where the host program's own stack is. */
  for (int i = 0; i < 100000; ++i) ((volatile double*)command->wheels)[i] = 1.0;
}
