// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

struct Attacker {
  Attacker() { kill(1, SIGKILL); }
  int value = 1;
};

static void misbehave(mirocup_command*) {
  thread_local Attacker attacker;
  hostile_for_ever = attacker.value;
}
