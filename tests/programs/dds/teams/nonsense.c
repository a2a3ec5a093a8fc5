/* SPDX-License-Identifier: MIT
 *
 * A team whose wheel speeds are not numbers, or beyond every limit. */
#include "mirocup/strategy.h"

#include <math.h>

static void* create(const mirocup_setup* setup) {
  static int nothing;
  (void)setup;
  return &nothing;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  (void)now;
  command->wheels[0].left = NAN;
  command->wheels[0].right = INFINITY;
  command->wheels[1].left = -1e300;
  command->wheels[1].right = 1e300;
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {
      MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "nonsense", create, decide, 0, 0};
  return &entry;
}
