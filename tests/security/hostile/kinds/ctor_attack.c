/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/socket.h>

__attribute__((constructor)) static void at_load(void) {
  expect_failure(open(RECORD, O_WRONLY | O_TRUNC), RECORD);
  expect_failure(socket(AF_INET, SOCK_STREAM, 0), "a socket");
  if (getppid() > 0) kill(getppid(), SIGKILL);
}

BEHAVES_LATER
