/* SPDX-License-Identifier: MIT
 *
 * Its robots stand where they are put. The smallest possible team, in C, which every other team
 * should beat.
 */
#include "mirocup/strategy.h"

static void* create(const mirocup_setup* setup) {
  static int nothing_to_keep;
  (void)setup;
  return &nothing_to_keep;
}

static void decide(void* team, const mirocup_observation* observation, mirocup_command* command) {
  (void)team;
  (void)observation;
  (void)command; /* all zero already */
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "idle",
                                         .create = create,
                                         .decide = decide};
  return &entry;
}
