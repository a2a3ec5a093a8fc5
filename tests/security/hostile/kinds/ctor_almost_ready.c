/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  /* The last call of loading, many times and too early, and then on with opening. */
  for (int i = 0; i < 20; ++i) {
    syscall(SYS_landlock_restrict_self, -1, 0);
    const int file = open("/etc/ld.so.cache", O_RDONLY);
    if (file >= 0) close(file);
  }
}

BEHAVES_LATER
