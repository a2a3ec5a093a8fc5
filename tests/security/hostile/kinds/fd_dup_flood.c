/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int i = 0; i < 1000; ++i) {
    int ends[2];
    expect_failure(dup(2), "dup");
    expect_failure(pipe(ends), "pipe");
  }
}
