/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  expect_failure(open(SECRET, O_RDONLY), SECRET);
  expect_failure(open("/etc/passwd", O_RDONLY), "/etc/passwd");
  expect_failure(open("/proc/self/environ", O_RDONLY), "/proc/self/environ");
  expect_failure(open("/proc/1/cmdline", O_RDONLY), "/proc/1/cmdline");
  expect_failure(open(".", O_RDONLY | O_DIRECTORY), "a folder");
}

BEHAVES_LATER
