// SPDX-License-Identifier: MIT
//
// What the layering check must not let pass: the lowest room includes a higher one, knows time, and
// asks the C library.
#include "core/match/leg.hpp"

#include <chrono>

inline double wrong(double x) {
  return std::sin(x);
}
