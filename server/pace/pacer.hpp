// SPDX-License-Identifier: MIT
//
// How fast simulated time passes: real time, any factor of it, or as fast as everybody answers.
#pragma once

#include "server/pace/durations.hpp"
#include "server/pace/wall_clock.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>

namespace mirocup::pace {

class Pacer {
 public:
  // `factor`: simulated seconds per second; nothing: as fast as it goes. The clock outlives the
  // pacer.
  Pacer(WallClock& clock, double control_period, std::optional<double> factor)
      : clock_(clock), period_(factor ? control_period / *factor : 0.0) {
    assert(control_period > 0.0 && (!factor || *factor > 0.0));
  }

  // Returns when the tick is due. Ticks are counted from the first call, so a late one delays none
  // after it.
  void wait_for(std::uint32_t tick) {
    if (period_ == 0.0) return;
    if (!has_started_) start_ = clock_.now() - tick * period_;
    has_started_ = true;
    const double due = start_ + tick * period_;
    if (clock_.now() < due) clock_.sleep_until(due);
    lateness_.add(std::max(0.0, clock_.now() - due));
  }

  // Wall seconds between two ticks; 0: no limit.
  double period() const { return period_; }

  // By how much ticks began after they were due.
  const Durations& lateness() const { return lateness_; }

 private:
  WallClock& clock_;
  double period_;
  bool has_started_ = false;
  double start_ = 0.0;  // of tick 0
  Durations lateness_;
};

}  // namespace mirocup::pace
