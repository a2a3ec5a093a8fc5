/* SPDX-License-Identifier: MIT */
#define HOSTILE_CUSTOM_ENTRY
#include "tests/security/hostile/hostile.h"

static void* create(const mirocup_setup* setup) {
  setup->log(setup->host, "there is no plan for this field");
  return 0;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  (void)now;
  (void)command;
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {
      MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "none", create, decide, 0};
  return &entry;
}
