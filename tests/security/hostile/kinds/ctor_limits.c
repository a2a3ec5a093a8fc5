/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/resource.h>

__attribute__((constructor)) static void at_load(void) {
  const struct rlimit all = {RLIM_INFINITY, RLIM_INFINITY};
  expect_failure(setrlimit(RLIMIT_AS, &all), "more memory");
  expect_failure(prlimit(0, RLIMIT_CPU, &all, 0), "more time");
}

BEHAVES_LATER
