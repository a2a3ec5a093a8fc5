/* SPDX-License-Identifier: MIT
 *
 * A team whose commands depend on the time of day from tick 40 on.
 */
#define _POSIX_C_SOURCE 199309L

#include "mirocup/strategy.h"

#include <time.h>

static void* create(const mirocup_setup* setup) {
  static int nothing;
  (void)setup;
  return &nothing;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  struct timespec time = {0, 0};
  (void)team;
  if (now->tick < 40) return;
  clock_gettime(CLOCK_REALTIME, &time);
  command->wheels[0].left = (double)(time.tv_nsec % 8192) / 256.0;
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "moody",
                                         .create = create,
                                         .decide = decide};
  return &entry;
}
