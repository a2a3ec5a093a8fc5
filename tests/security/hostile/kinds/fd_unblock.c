/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Makes the log's pipe blocking: then each write to a full log would wait for the server. */
  expect_failure(fcntl(2, F_SETFL, 0), "a blocking log");
}
