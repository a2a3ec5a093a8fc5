/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  while (hostile_for_ever) {
  }
}

BEHAVES_LATER
