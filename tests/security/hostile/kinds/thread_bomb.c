/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <pthread.h>

static void* nothing(void* it) {
  return it;
}

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int i = 0; i < 100; ++i) {
    pthread_t thread;
    if (pthread_create(&thread, 0, nothing, 0) == 0) got_through("a thread");
  }
}
