/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

/* One stack frame that is larger than any guard area, so that it jumps over it. */
__attribute__((noinline)) static int huge(int depth) {
  volatile char frame[8 << 20];
  frame[0] = 1;
  __asm__ volatile("" : : "r"(frame) : "memory"); /* keeps the compiler from removing it */
  return depth > 0 ? huge(depth - 1) + frame[0] : frame[0];
}

static void misbehave(mirocup_command* command) {
  (void)command;
  hostile_for_ever = huge(3);
}
