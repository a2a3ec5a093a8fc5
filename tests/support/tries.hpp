// SPDX-License-Identifier: MIT
//
// How often a test tries something at a random place or moment: a few times by itself, MIROCUP_TRIES
// times for those who want to know.
#pragma once

#include <cstdlib>

namespace mirocup::test_support {

inline int tries(int by_itself) {
  const char* wanted = std::getenv("MIROCUP_TRIES");
  return wanted != nullptr ? std::atoi(wanted) : by_itself;
}

}  // namespace mirocup::test_support
