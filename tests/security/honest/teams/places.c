/* SPDX-License-Identifier: MIT
 *
 * A team in plain C that chooses its places at restarts.
 */
#include "mirocup/strategy.h"

static const mirocup_setup* told;

static void* create(const mirocup_setup* setup) {
  static int nothing_to_keep;
  told = setup;
  setup->log(setup->host, "with places of its own");
  return &nothing_to_keep;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  for (int i = 0; i < now->robots; ++i) {
    command->wheels[i].left = 0.5 * told->wheel_speed_limit;
    command->wheels[i].right = 0.4 * told->wheel_speed_limit;
  }
}

static void place(void* team, const mirocup_observation* now, mirocup_placement* placement) {
  (void)team;
  const double x = -0.3 * told->half_length;
  for (int i = 2; i < now->robots; ++i) {
    placement->robots[i].x = x;
    placement->robots[i].y = 0.12 * (i - 2);
    placement->robots[i].heading = 0.1 * i;
  }
  if (now->restart == MIROCUP_KICK_OFF && now->own_restart != 0) placement->ball_x = -0.05;
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {.abi_version = MIROCUP_ABI_VERSION,
                                         .size = sizeof(mirocup_strategy),
                                         .name = "places",
                                         .create = create,
                                         .decide = decide,
                                         .place = place};
  return &entry;
}
