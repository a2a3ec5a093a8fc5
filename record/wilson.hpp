// SPDX-License-Identifier: MIT
//
// The interval of a share that was counted in some tries.
#pragma once

#include <algorithm>
#include <cmath>

namespace mirocup::record {

struct Interval {
  double low = 0.0;
  double high = 1.0;
};

// Returns the interval of 95 % for a probability (E. B. Wilson, 1927). `share` is the part of the
// `tries` that came out well, in [0, 1]; there is at least one try.
inline Interval wilson_interval(double share, double tries) {
  constexpr double z = 1.959963984540054;
  const double scale = 1.0 + z * z / tries;
  const double middle = (share + z * z / (2.0 * tries)) / scale;
  const double reach =
      z / scale * std::sqrt(share * (1.0 - share) / tries + z * z / (4.0 * tries * tries));
  return {std::max(0.0, middle - reach), std::min(1.0, middle + reach)};
}

}  // namespace mirocup::record
