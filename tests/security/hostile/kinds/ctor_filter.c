/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <linux/filter.h>

__attribute__((constructor)) static void at_load(void) {
  /* Keeps the second part of the sandbox from being built: answers seccomp() with EPERM. */
  struct sock_filter program[] = {{0x20, 0, 0, 0},
                                  {0x15, 0, 1, SYS_seccomp},
                                  {0x06, 0, 0, 0x00050000 | EPERM},
                                  {0x06, 0, 0, 0x7fff0000}};
  const struct sock_fprog filter = {4, program};
  syscall(SYS_seccomp, 1, 0, &filter);
}

BEHAVES_LATER
