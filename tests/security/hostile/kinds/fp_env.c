/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <fenv.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  fesetround(FE_UPWARD);
  feenableexcept(FE_ALL_EXCEPT);
}
