// SPDX-License-Identifier: MIT
//
// How fast simulated time passes: real time, any factor of it, or as fast as everybody answers.
#pragma once

#include "server/pace/clock.hpp"

#include <cstdint>
#include <optional>

namespace mirocup::pace {

class Pacer {
 public:
  // `factor`: simulated seconds per second; nothing: as fast as it goes. The clock outlives the
  // pacer.
  Pacer(Clock& clock, double control_period, std::optional<double> factor)
      : clock_(clock), period_(factor ? control_period / *factor : 0.0) {}

  // Returns when the tick is due. Ticks are counted from the first call, so a late one delays none
  // after it.
  void wait_for(std::uint32_t tick) {
    if (period_ == 0.0) return;
    if (!has_begun_) begin_ = clock_.now() - tick * period_;
    has_begun_ = true;
    const double due = begin_ + tick * period_;
    if (clock_.now() < due) clock_.sleep_until(due);
  }

  // Wall seconds between two ticks; 0: no limit.
  double period() const { return period_; }

 private:
  Clock& clock_;
  double period_;
  bool has_begun_ = false;
  double begin_ = 0.0;  // of tick 0
};

}  // namespace mirocup::pace
