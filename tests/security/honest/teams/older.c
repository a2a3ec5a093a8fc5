/* SPDX-License-Identifier: MIT
 *
 * A library that was built before place() existed: its structure ends earlier, and the memory
 * behind it holds something else.
 */
#include "mirocup/strategy.h"

#include <stddef.h>
#include <string.h>

static void* create(const mirocup_setup* setup) {
  static int nothing_to_keep;
  setup->log("from before place()");
  return &nothing_to_keep;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  for (int i = 0; i < now->robots; ++i) command->wheels[i].left = 10.0;
}

const mirocup_strategy* mirocup_entry(void) {
  static mirocup_strategy entry;
  memset(&entry, 0x55, sizeof entry);
  entry.abi_version = MIROCUP_ABI_VERSION;
  entry.size = offsetof(mirocup_strategy, place);
  entry.name = "older";
  entry.create = create;
  entry.decide = decide;
  entry.destroy = 0;
  return &entry;
}
