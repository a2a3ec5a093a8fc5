/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  if (hostile_now->tick == hostile_tick) burn(0.9);
  if (hostile_now->tick == hostile_tick + 1) burn(0.9);
  /* Most of the bank is spent: the time of a tick would end later. */
  while (hostile_now->tick > hostile_tick + 1) {
  }
}
