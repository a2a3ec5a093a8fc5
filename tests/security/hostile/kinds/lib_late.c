/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <dlfcn.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  if (dlopen(MIROCUP_TARGET "/libevil.so", RTLD_NOW) != 0) got_through("libevil.so");
}
