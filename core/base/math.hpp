// SPDX-License-Identifier: MIT
//
// Elementary functions that give the same bits everywhere.
//
// The C library may round sin, cos, exp and atan2 differently from one version or machine to the
// next; a match must not. These use only + - * / and sqrt, which IEEE 754 fixes to the last bit.
// Errors, held against a 64-bit mantissa in tests/unit/core/base/math_test.cpp: at most 1 ulp of
// the result for sine and cosine up to 1000 rad (below 0.01: of 0.01) and for exp, 5 ulp for the
// others.
#pragma once

#include <array>
#include <limits>

namespace mirocup {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct SinCos {
  double sin;
  double cos;
};

// Sine and cosine of x in radians; |x| up to 1e5 keeps the accuracy above.
SinCos sincos(double x);

// The same bits for some angles at once, none beyond pi/4, in less than half of the instructions.
inline constexpr int angles_at_once = 8;
inline constexpr double small_angle = 0.25 * pi;
struct SinCosOfSome {
  std::array<double, angles_at_once> sin;
  std::array<double, angles_at_once> cos;
};
SinCosOfSome sincos_of_small(const std::array<double, angles_at_once>& x);

// e^x. Overflows to infinity above 709.8, is 0 below -745.2.
double exp(double x);

// e^x - 1, accurate near 0.
double expm1(double x);

// ln(1 + x) for x > -1, accurate near 0.
double log1p(double x);

// The angle of (x, y) in (-pi, pi], counter-clockwise from +x; 0 for the null vector.
double atan2(double y, double x);

}  // namespace mirocup
