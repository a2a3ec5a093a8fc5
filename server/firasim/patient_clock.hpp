// SPDX-License-Identifier: MIT
//
// A clock for waiting for a team. The clock stops while the machine is stopped, or is so busy that
// this process does not run, because then the team cannot answer either.
#pragma once

#include <algorithm>
#include <chrono>

namespace mirocup::firasim {

class PatientClock {
 public:
  // Returns seconds since an arbitrary moment. Between two calls the clock advances by at most
  // `most_at_once`, so a caller that waits for a team must call at least that often.
  double now() {
    const Clock::time_point seen = Clock::now();
    const double step = std::chrono::duration<double>(seen - seen_).count();
    seen_ = seen;
    now_ += std::min(step, most_at_once);
    return now_;
  }

  static constexpr double most_at_once = 0.2;  // s

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point seen_ = Clock::now();
  double now_ = 0.0;
};

}  // namespace mirocup::firasim
