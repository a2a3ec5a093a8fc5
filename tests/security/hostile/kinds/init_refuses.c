/* SPDX-License-Identifier: MIT */
#define HOSTILE_CREATE create
#include "tests/security/hostile/hostile.h"

BEHAVES_LATER

static void* create(const mirocup_setup* setup) {
  setup->log(setup->host, "there is no plan for this field");
  return 0;
}
