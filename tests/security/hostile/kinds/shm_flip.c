/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  /* Changes the words before the answers: "answered" too early, and codes of ends that do not
   * happen. */
  volatile unsigned* page =
      (volatile unsigned*)(((uintptr_t)hostile_now & ~(uintptr_t)4095) - 4096);
  for (unsigned i = 0; i < 1000; ++i) {
    page[0] = hostile_now->tick + 1 + i % 3;
    page[1] = i % 5;
    page[2] = i % 65;
    page[3] = i % 500;
    command->wheels[0].left = i % 2 == 0 ? 1e300 : -1e300;
  }
}
