/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((constructor)) static void at_load(void) {
  char* const arguments[] = {"/bin/sh", "-c", "echo >" RECORD, 0};
  char* const environment[] = {"LD_PRELOAD=" MIROCUP_TARGET "/libevil.so", 0};
  execve(arguments[0], arguments, environment);
}

BEHAVES_LATER
