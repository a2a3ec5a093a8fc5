/* SPDX-License-Identifier: MIT */
#include "mirocup/strategy.h"

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {
      MIROCUP_ABI_VERSION + 1, sizeof(mirocup_strategy), "other", 0, 0, 0};
  return &entry;
}
