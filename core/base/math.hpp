// SPDX-License-Identifier: MIT
//
// Elementary functions that give the same bits on every machine.
//
// The C library may round sin, cos, exp and atan2 differently from one version or machine to the
// next; a match must not depend on that. These functions use only + - * / and sqrt, which IEEE 754
// fixes to the last bit. Largest errors, measured against a 64-bit mantissa in
// tests/unit/core/base/math_test.cpp:
//
//   exp                         1 ulp of the result
//   sine, cosine to 1000 rad    1 ulp of the result; of results below 0.01, 1 ulp of 0.01
//   expm1, log1p, atan2         5 ulp of the result
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

// Returns sine and cosine of x in radians. The accuracy above holds for |x| up to 1e3.
SinCos sincos(double x);

// Returns sines and cosines of eight angles, with the same bits as sincos() in less than half of
// the instructions. No |x| may exceed small_angle.
inline constexpr int angles_at_once = 8;
inline constexpr double small_angle = 0.25 * pi;
struct SinCosOfSome {
  std::array<double, angles_at_once> sin;
  std::array<double, angles_at_once> cos;
};
SinCosOfSome sincos_of_small(const std::array<double, angles_at_once>& x);

// Returns e^x. Overflows to infinity above 709.8, is 0 below -745.2.
double exp(double x);

// Returns e^x - 1, accurate near 0.
double expm1(double x);

// Returns ln(1 + x) for x > -1, accurate near 0.
double log1p(double x);

// Returns the angle of (x, y) in (-pi, pi], counter-clockwise from +x; 0 for the null vector.
double atan2(double y, double x);

}  // namespace mirocup
