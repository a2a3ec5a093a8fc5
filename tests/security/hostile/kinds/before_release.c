/* SPDX-License-Identifier: MIT
 *
 * A library of a strategy.h that was never released: its structures have another layout, which
 * shows in the size of this one. Where it was loaded, it decided on garbage and stood still.
 */
#include "mirocup/strategy.h"

#include <stddef.h>

static void* create(const mirocup_setup* setup) {
  static int nothing_to_keep;
  (void)setup;
  return &nothing_to_keep;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team, (void)now, (void)command;
}

const mirocup_strategy* mirocup_entry(void) {
  static mirocup_strategy entry;
  entry.abi_version = MIROCUP_ABI_VERSION;
  entry.size = offsetof(mirocup_strategy, place);
  entry.create = create;
  entry.decide = decide;
  return &entry;
}
