/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/stat.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  struct stat status;
  expect_failure(stat(SECRET, &status), "stat");
}
