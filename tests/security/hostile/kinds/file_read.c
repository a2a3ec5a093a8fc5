/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  expect_failure(open(SECRET, O_RDONLY), SECRET);
  expect_failure(open("/etc/passwd", O_RDONLY), "/etc/passwd");
  expect_failure(open("/proc/self/mem", O_RDWR), "/proc/self/mem");
}
