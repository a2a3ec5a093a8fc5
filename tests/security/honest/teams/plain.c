/* SPDX-License-Identifier: MIT */
#include "mirocup/strategy.h"

#include <stdio.h>
#include <stdlib.h>

static void* create(const mirocup_setup* setup) {
  mirocup_setup* copy = malloc(sizeof *copy);
  *copy = *setup;
  setup->log(setup->host, "in C");
  return copy;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  const mirocup_setup* setup = team;
  for (int i = 0; i < now->robots; ++i) {
    command->wheels[i].left = 0.25 * setup->wheel_speed_limit;
    command->wheels[i].right = 0.5 * setup->wheel_speed_limit;
  }
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "plain",
                                         .create = create,
                                         .decide = decide,
                                         .destroy = free};
  return &entry;
}
