/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  hostile_for_ever = 7777 / (hostile_for_ever - 1);
}
