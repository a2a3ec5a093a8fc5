// SPDX-License-Identifier: MIT
//
// The layering check must not accept this file: the lowest room includes a higher one, knows time,
// and calls the C library.
#include "core/match/leg.hpp"

#include <chrono>

inline double wrong(double x) {
  return std::sin(x);
}
