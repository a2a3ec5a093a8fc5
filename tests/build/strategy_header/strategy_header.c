/* SPDX-License-Identifier: MIT */
#include "mirocup/strategy.h"

const mirocup_strategy* mirocup_entry(void) {
  return 0;
}
