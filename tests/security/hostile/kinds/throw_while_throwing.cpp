// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <stdexcept>

struct Bomb {
  ~Bomb() noexcept(false) { throw std::runtime_error("twice"); }
};

static void misbehave(mirocup_command*) {
  const Bomb bomb;
  throw 1;
}
