/* SPDX-License-Identifier: MIT */
#include "mirocup/strategy.h"

void team_decide(int32_t robots, double ball_x, double ball_y, double* wheels);

static void* create(const mirocup_setup* setup) {
  static int nothing_to_keep;
  setup->log(setup->host, "in Fortran");
  return &nothing_to_keep;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  team_decide(now->robots, now->ball_x, now->ball_y, &command->wheels[0].left);
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "fortran",
                                         .create = create,
                                         .decide = decide};
  return &entry;
}
