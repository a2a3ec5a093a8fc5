/* SPDX-License-Identifier: MIT
 *
 * A team whose wheels turn at its parameter "speed", rad/s, which it also logs.
 */
#include "mirocup/strategy.h"

#include <stdio.h>
#include <stdlib.h>

static void* create(const mirocup_setup* setup) {
  double* speed = malloc(sizeof *speed);
  char line[64];
  if (speed == NULL) return NULL;
  *speed = setup->parameter(setup->host, "speed", 3.0);
  snprintf(line, sizeof line, "team %d turns at %g", (int)setup->team, *speed);
  setup->log(setup->host, line);
  return speed;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  const double speed = *(const double*)team;
  for (int i = 0; i < now->robots; ++i) {
    command->wheels[i].left = -speed;
    command->wheels[i].right = speed;
  }
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "tuned",
                                         .create = create,
                                         .decide = decide,
                                         .destroy = free};
  return &entry;
}
