/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((noinline)) static int deeper(int depth) {
  volatile char frame[4096];
  frame[depth % 4096] = 1;
  return deeper(depth + 1) + frame[0];
}

static void misbehave(mirocup_command* command) {
  (void)command;
  const stack_t none = {0, SS_DISABLE, 0};
  sigaltstack(&none, 0);
  hostile_for_ever = deeper(1);
}
