/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int i = 0; i < 100; ++i) expect_failure(fork(), "fork");
}
