/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/socket.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  expect_failure(socket(AF_INET, SOCK_STREAM, 0), "TCP");
  expect_failure(socket(AF_INET, SOCK_DGRAM, 0), "UDP");
  expect_failure(socket(AF_UNIX, SOCK_STREAM, 0), "a local socket");
  expect_failure(socket(AF_NETLINK, SOCK_RAW, 0), "netlink");
}
