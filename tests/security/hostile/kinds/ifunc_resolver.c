/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

/* Runs while the library is relocated, before any constructor, and cannot call the C library. */
static long raw_call(long number, long a, long b, long c) {
#if defined(__x86_64__)
  long result;
  __asm__ volatile("syscall"
                   : "=a"(result)
                   : "a"(number), "D"(a), "S"(b), "d"(c)
                   : "rcx", "r11", "memory");
  return result;
#else
  (void)number, (void)a, (void)b, (void)c;
  return -1;
#endif
}

static int harmless(void) {
  return 1;
}

static int (*resolve(void))(void) {
  static const char words[] = "GOT THROUGH: while relocated\n";
  if (raw_call(SYS_openat, AT_FDCWD, (long)SECRET, O_RDONLY) >= 0)
    raw_call(SYS_write, 2, (long)words, sizeof words - 1);
  return harmless;
}

int chosen(void) __attribute__((ifunc("resolve")));

static void misbehave(mirocup_command* command) {
  (void)command;
  hostile_for_ever = chosen();
}
