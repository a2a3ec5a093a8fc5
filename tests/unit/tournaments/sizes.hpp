// SPDX-License-Identifier: MIT
//
// The numbers of teams for which a property of leagues is tested: 2 to 64.
#pragma once

#include <gtest/gtest.h>

namespace mirocup::league {

inline auto all_sizes() {
#ifdef MIROCUP_SANITIZED
  constexpr int step = 6;  // sanitizers are slow; the release build tests every size
#else
  constexpr int step = 1;
#endif
  return testing::Range(2, 65, step);
}

}  // namespace mirocup::league
