/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
#if defined(__x86_64__)
  /* getpid() of the 32-bit architecture, whose numbers mean other calls. */
  __asm__ volatile("int $0x80" : : "a"(20) : "memory");
#else
  kill(1, 0);
#endif
}
