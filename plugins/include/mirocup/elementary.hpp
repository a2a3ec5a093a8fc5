// SPDX-License-Identifier: MIT
//
// The functions of elementary.h under the names that C++ has: math::sin(x) after `using namespace
// mirocup::strategy`. The functions give the same bits on every system, unlike std::sin(x).
// elementary.h says why a team needs equal bits, and how exact the functions are.
#pragma once

#include "mirocup/elementary.h"

namespace mirocup::strategy::math {

inline constexpr auto& sin = mirocup_sin;
inline constexpr auto& cos = mirocup_cos;
inline constexpr auto& tan = mirocup_tan;
inline constexpr auto& asin = mirocup_asin;
inline constexpr auto& acos = mirocup_acos;
inline constexpr auto& atan = mirocup_atan;
inline constexpr auto& atan2 = mirocup_atan2;
inline constexpr auto& hypot = mirocup_hypot;
inline constexpr auto& exp = mirocup_exp;
inline constexpr auto& expm1 = mirocup_expm1;
inline constexpr auto& log = mirocup_log;
inline constexpr auto& log1p = mirocup_log1p;

// Like std::min(), std::max() and std::clamp() of doubles, but without <algorithm>, which is slow
// to compile.
inline double min(double a, double b) {
  return b < a ? b : a;
}
inline double max(double a, double b) {
  return a < b ? b : a;
}
inline double clamp(double x, double low, double high) {
  return x < low ? low : high < x ? high : x;
}

}  // namespace mirocup::strategy::math
