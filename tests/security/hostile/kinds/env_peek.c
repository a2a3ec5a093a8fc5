/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* The test puts this into the server's environment. */
  if (getenv("MIROCUP_TEST_SECRET") != 0) got_through("the server's environment");
}
