// SPDX-License-Identifier: MIT
#include "tests/security/hostile/hostile.h"

#include <fstream>
#include <string>

static void misbehave(mirocup_command*) {
  std::ofstream(RECORD) << "changed";
  std::string word;
  if (std::ifstream(SECRET) >> word) got_through("std::ifstream");
}
