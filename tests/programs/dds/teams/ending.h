/* SPDX-License-Identifier: MIT
 *
 * A team that drives in circles, logs "tick 2" when that tick comes, and sends its own process the
 * signal ENDING at tick 30. */
#define _POSIX_C_SOURCE 199309L
#include "mirocup/strategy.h"

#include <signal.h>

static void* create(const mirocup_setup* setup) {
  static mirocup_setup own;
  own = *setup;
  return &own;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  const mirocup_setup* own = team;
  int i;
  if (now->tick == 2) own->log(own->host, "tick 2");
  if (now->tick == 30) raise(ENDING);
  for (i = 0; i < now->robots; ++i) {
    command->wheels[i].left = 10.0;
    command->wheels[i].right = 20.0;
  }
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {
      MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "ending", create, decide, 0, 0};
  return &entry;
}
