/* SPDX-License-Identifier: MIT */
#include "tests/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  rename(RECORD, RECORD ".old");
}
