// SPDX-License-Identifier: MIT
//
// Elementary functions that give the same bits on every machine, under the names that core uses.
// Their implementation is plugins/include/mirocup/elementary.h, which teams also use; that header
// states errors and domains.
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

// Returns sine and cosine of x in radians.
SinCos sincos(double x);

// Returns sines and cosines of eight angles: the same bits as eight calls of sincos(), with less
// than half of their instructions. No |x| may exceed small_angle.
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
