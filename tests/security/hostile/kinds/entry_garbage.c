/* SPDX-License-Identifier: MIT */
#define HOSTILE_CUSTOM_ENTRY
#include "tests/security/hostile/hostile.h"

const mirocup_strategy* mirocup_entry(void) {
  return (const mirocup_strategy*)hostile_nowhere;
}
