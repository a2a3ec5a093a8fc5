/* SPDX-License-Identifier: MIT */
#define HOSTILE_CUSTOM_ENTRY
#include "tests/security/hostile/hostile.h"

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {
      MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "none", 0, 0, 0};
  return &entry;
}
