/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  for (int number = 1; number < 32; ++number) signal(number, SIG_IGN);
  while (hostile_for_ever) {
  }
}
