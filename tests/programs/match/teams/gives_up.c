/* SPDX-License-Identifier: MIT
 *
 * A team that dies in tick 40.
 */
#include "mirocup/strategy.h"

#include <stdlib.h>

static void* create(const mirocup_setup* setup) {
  static int nothing;
  (void)setup;
  return &nothing;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  (void)command;
  if (now->tick >= 40) abort();
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "gives up",
                                         .create = create,
                                         .decide = decide};
  return &entry;
}
