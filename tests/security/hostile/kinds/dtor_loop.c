/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

__attribute__((destructor)) static void at_unload(void) {
  while (hostile_for_ever) {
  }
}

static void misbehave(mirocup_command* command) {
  (void)command;
}
