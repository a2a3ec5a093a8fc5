/* SPDX-License-Identifier: MIT
 *
 * The frame of a test strategy: it behaves until the tick in which it does what its file is called.
 */
#ifndef MIROCUP_TESTS_HOSTILE_H
#define MIROCUP_TESTS_HOSTILE_H

#include "mirocup/strategy.h"

enum { hostile_tick = 25 };

static void misbehave(mirocup_command* command);

static void* hostile_create(const mirocup_setup* setup) {
  static int something;
  (void)setup;
  return &something;
}

static void hostile_decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  if (now->tick >= hostile_tick) misbehave(command);
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "hostile",
                                         hostile_create,      hostile_decide,           0};
  return &entry;
}

#endif
