// SPDX-License-Identifier: MIT
//
// The number of tries of a test that acts at random places or moments: a few by default,
// MIROCUP_TRIES for a long run.
#pragma once

#include <cstdlib>

namespace mirocup::test_support {

inline int tries(int by_itself) {
  const char* wanted = std::getenv("MIROCUP_TRIES");
  return wanted != nullptr ? std::atoi(wanted) : by_itself;
}

}  // namespace mirocup::test_support
