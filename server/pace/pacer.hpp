// SPDX-License-Identifier: MIT
//
// The speed of a match: real time, a multiple of it, or as fast as the teams answer.
#pragma once

#include "record/durations.hpp"
#include "server/pace/wall_clock.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>

namespace mirocup::pace {

class Pacer {
 public:
  // `control_period`: simulated seconds of a tick. `factor`: simulated seconds per second of wall
  // time; if empty, the pacer never waits. The clock must outlive the pacer.
  Pacer(WallClock& clock, double control_period, std::optional<double> factor)
      : clock_(clock), period_(factor ? control_period / *factor : 0.0) {
    assert(control_period > 0.0 && (!factor || *factor > 0.0));
  }

  // Waits until the tick is due. The due times of all ticks count from the first call, so a late
  // tick does not delay later ticks.
  void wait_for(std::uint32_t tick) {
    if (period_ == 0.0) return;
    if (!has_started_) start_ = clock_.now() - tick * period_;
    has_started_ = true;
    const double due = start_ + tick * period_;
    if (clock_.now() < due) clock_.sleep_until(due);
    lateness_.add(std::max(0.0, clock_.now() - due));
  }

  // Returns the wall time between two ticks, s; 0 if the pacer never waits.
  double period() const { return period_; }

  // Returns the delays of the ticks: start minus due time. Empty if the pacer never waits.
  const record::Durations& lateness() const { return lateness_; }

 private:
  WallClock& clock_;
  double period_;
  bool has_started_ = false;
  double start_ = 0.0;  // when tick 0 was due
  record::Durations lateness_;
};

}  // namespace mirocup::pace
