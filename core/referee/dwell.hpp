// SPDX-License-Identifier: MIT
//
// How long something has held without a break, counted in samples.
//
// The first sample in which it holds counts as 0 s. A limit is reached at the sample nearest to it,
// so 0.50 s at 33 ms a sample are 15 samples more.
#pragma once

namespace mirocup::referee {

struct Dwell {
  bool holds = false;
  double for_s = 0.0;

  void sample(bool now, double duration) {
    for_s = now && holds ? for_s + duration : 0.0;
    holds = now;
  }

  bool reached(double limit, double duration) const {
    return holds && for_s + duration / 2.0 >= limit;
  }
};

}  // namespace mirocup::referee
