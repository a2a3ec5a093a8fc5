// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <stdexcept>

static void misbehave(mirocup_command*) {
  throw std::runtime_error(
      "\x1b[2J\xff\xe2\x80\xae"
      "red");
}
