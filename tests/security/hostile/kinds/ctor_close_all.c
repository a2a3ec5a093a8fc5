/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  for (int fd = 0; fd < 1024; ++fd) close(fd);
}

BEHAVES_LATER
