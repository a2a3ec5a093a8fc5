// SPDX-License-Identifier: MIT
//
// A dwell timer: how long a condition has held without a break, counted in samples.
//
// The first sample in which the condition holds counts as 0 s. A limit is reached at the sample
// nearest to it: at 33 ms a sample, 0.50 s are reached 15 samples after the first.
#pragma once

namespace mirocup::referee {

struct Dwell {
  bool holds = false;  // true if the condition held at the last sample
  double for_s = 0.0;  // since the first sample in which it held

  // Adds a sample that lasts `duration` seconds.
  void sample(bool now, double duration) {
    for_s = now && holds ? for_s + duration : 0.0;
    holds = now;
  }

  // True if the condition has held for `limit` seconds, to the nearest sample.
  bool reached(double limit, double duration) const {
    return holds && for_s + duration / 2.0 >= limit;
  }
};

}  // namespace mirocup::referee
