// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <stdexcept>

static void misbehave(mirocup_command*) {
  throw std::runtime_error("thrown on purpose");
}
