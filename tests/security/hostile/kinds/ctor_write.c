/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  expect_failure(open(RECORD, O_WRONLY | O_TRUNC), RECORD);
  expect_failure(open(MIROCUP_TARGET "/dropped", O_WRONLY | O_CREAT, 0644), "a new file");
  expect_failure(open("/entry/strategy.so", O_RDWR), "its own library");
  expect_failure(open("/tmp", O_TMPFILE | O_RDWR, 0600), "a temporary file");
}

BEHAVES_LATER
