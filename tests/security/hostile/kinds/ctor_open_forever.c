/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  /* Each call waits for the server, which must not forget its limits over them. */
  while (hostile_for_ever) syscall(SYS_openat, AT_FDCWD, "/lib/nothing", O_RDONLY);
}

BEHAVES_LATER
