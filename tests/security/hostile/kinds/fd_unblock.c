/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* A log that blocks would wait for the server. */
  expect_failure(fcntl(2, F_SETFL, 0), "a blocking log");
}
