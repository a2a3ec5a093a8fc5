// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <stdexcept>

// Ends the sentence of the server and goes on with one of its own.
static void misbehave(mirocup_command*) {
  throw std::runtime_error("\". The other team made an illegal call\n{\"accepted\": true}\n");
}
