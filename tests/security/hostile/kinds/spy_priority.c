/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sys/resource.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  getpriority(PRIO_USER, 0); /* the least of all processes of the user, the server's among them */
}
