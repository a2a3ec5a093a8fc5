/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  static char block[1 << 20];
  expect_failure(mlock(block, sizeof block), "mlock");
}
