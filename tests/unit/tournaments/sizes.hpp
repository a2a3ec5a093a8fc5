// SPDX-License-Identifier: MIT
//
// For how many teams a property of leagues is tried: 2 to 64.
#pragma once

#include <gtest/gtest.h>

namespace mirocup::league {

inline auto all_sizes() {
#ifdef MIROCUP_SANITIZED
  constexpr int step = 6;  // slow there; the release build tries every size
#else
  constexpr int step = 1;
#endif
  return testing::Range(2, 65, step);
}

}  // namespace mirocup::league
