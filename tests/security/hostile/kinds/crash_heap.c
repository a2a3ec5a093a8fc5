/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  int* volatile twice = malloc(16);
  free(twice);
  free(twice);
}
