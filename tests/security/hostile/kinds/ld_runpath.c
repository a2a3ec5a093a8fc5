/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

/* Linked with a library in a folder that the sandbox must not read (CMakeLists.txt). */
extern int evil(void);

static void misbehave(mirocup_command* command) {
  (void)command;
  hostile_for_ever = evil();
}
