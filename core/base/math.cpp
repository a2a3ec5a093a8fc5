// SPDX-License-Identifier: MIT
#include "core/base/math.hpp"

#include "core/base/assert.hpp"
#include "plugins/include/mirocup/elementary.h"

#include <cmath>

namespace mirocup {

SinCos sincos(double x) {
  const mirocup_sine_cosine r = mirocup_sincos(x);
  return {r.sine, r.cosine};
}

// The same operations as mirocup_sincos_octant() with low = 0, arranged so that a compiler can
// vectorise them.
SinCosOfSome sincos_of_small(const std::array<double, angles_at_once>& x) {
  SinCosOfSome some;
  for (int i = 0; i < angles_at_once; ++i) {
    MIROCUP_ASSERT(std::abs(x[i]) <= small_angle);
    const double z = x[i] * x[i];
    const double half = 0.5 * z;
    const double one_minus_half = 1.0 - half;
    some.sin[i] = x[i] + x[i] * z * mirocup_sine_tail(z);
    some.cos[i] =
        one_minus_half + (((1.0 - one_minus_half) - half) + z * z * mirocup_cosine_tail(z));
  }
  return some;
}

double exp(double x) {
  return mirocup_exp(x);
}

double expm1(double x) {
  return mirocup_expm1(x);
}

double log1p(double x) {
  MIROCUP_ASSERT(x > -1.0);
  return mirocup_log1p(x);
}

double atan2(double y, double x) {
  return mirocup_atan2(y, x);
}

}  // namespace mirocup
