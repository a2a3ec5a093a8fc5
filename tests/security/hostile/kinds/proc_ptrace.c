/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/uio.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  char byte;
  const struct iovec here = {&byte, 1}, there = {(void*)hostile_nowhere, 1};
  if (getppid() > 0) process_vm_readv(getppid(), &here, 1, &there, 1, 0);
}
