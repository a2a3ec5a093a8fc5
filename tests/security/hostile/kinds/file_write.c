/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  expect_failure(open(RECORD, O_WRONLY | O_APPEND), RECORD);
  (void)!truncate(RECORD, 0);
}
