// SPDX-License-Identifier: MIT
//
// The functions of elementary.h under the names that C++ has: math::sin(x) after `using namespace
// mirocup::strategy`. The functions give the same bits on every system, unlike std::sin(x).
// elementary.h says why a team needs equal bits, and how exact the functions are.
#pragma once

#include "mirocup/elementary.h"

namespace mirocup::strategy::math {

inline double sin(double x) {
  return mirocup_sin(x);
}
inline double cos(double x) {
  return mirocup_cos(x);
}
inline double tan(double x) {
  return mirocup_tan(x);
}
inline double asin(double x) {
  return mirocup_asin(x);
}
inline double acos(double x) {
  return mirocup_acos(x);
}
inline double atan(double x) {
  return mirocup_atan(x);
}
inline double atan2(double y, double x) {
  return mirocup_atan2(y, x);
}
inline double hypot(double x, double y) {
  return mirocup_hypot(x, y);
}
inline double exp(double x) {
  return mirocup_exp(x);
}
inline double expm1(double x) {
  return mirocup_expm1(x);
}
inline double log(double x) {
  return mirocup_log(x);
}
inline double log1p(double x) {
  return mirocup_log1p(x);
}

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
