/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  exit(0);
}

BEHAVES_LATER
