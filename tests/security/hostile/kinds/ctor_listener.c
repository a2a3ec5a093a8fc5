/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <linux/filter.h>

__attribute__((constructor)) static void at_load(void) {
  /* A process that listens to a seccomp filter decides the calls of other processes. */
  struct sock_filter all = {0x06, 0, 0, 0x7fff0000};
  const struct sock_fprog filter = {1, &all};
  expect_failure(syscall(SYS_seccomp, 1, 8, &filter), "a listener");
}

BEHAVES_LATER
