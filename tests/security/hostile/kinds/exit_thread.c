/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <pthread.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  pthread_exit(0);
}
