/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/prctl.h>

__attribute__((constructor)) static void at_load(void) {
  expect_failure(prctl(PR_SET_PDEATHSIG, 0), "the parent's death");
  expect_failure(prctl(PR_SET_DUMPABLE, 1), "dumpable");
}

BEHAVES_LATER
