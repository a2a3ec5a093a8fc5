/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static unsigned seed(void) {
  struct timespec now;
  timespec_get(&now, TIME_UTC);
  return (unsigned)now.tv_sec;
}

static void misbehave(mirocup_command* command) {
  static int is_seeded;
  if (!is_seeded) srand(seed()); /* the same in every leg of a second */
  is_seeded = 1;
  answer_by((unsigned)rand(), command);
}
