// SPDX-License-Identifier: MIT
//
// The speed of a match: real time, a multiple of it, or as fast as the teams answer.
#pragma once

#include "record/durations.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <thread>

namespace mirocup::pace {

// Wall time, which the simulation never reads. Tests replace the clock.
class WallClock {
 public:
  virtual ~WallClock() = default;
  virtual double now() = 0;                   // s since an arbitrary moment; never decreases
  virtual void sleep_until(double time) = 0;  // returns at once if `time` has passed
};

class SteadyWallClock final : public WallClock {
 public:
  double now() override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  void sleep_until(double time) override {
    std::this_thread::sleep_until(start_ + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                               std::chrono::duration<double>(time)));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Pacer {
 public:
  // `control_period`: simulated seconds of a tick. `factor`: simulated seconds per second of wall
  // time; if empty, the pacer never waits. The clock must outlive the pacer.
  Pacer(WallClock& clock, double control_period, std::optional<double> factor)
      : clock_(clock), period_(factor ? control_period / *factor : 0.0) {
    assert(control_period > 0.0 && (!factor || *factor > 0.0));
  }

  // Waits until the tick is due. The due times of all ticks count from the first call, so a late
  // tick does not delay later ticks. Calls `meanwhile` ten times a second.
  void wait_for(
      std::uint32_t tick, const std::function<void()>& meanwhile = [] {}) {
    if (period_ == 0.0) return;
    if (!has_started_) start_ = clock_.now() - tick * period_;
    has_started_ = true;
    const double due = start_ + tick * period_;
    for (; clock_.now() + pause < due; meanwhile()) clock_.sleep_until(clock_.now() + pause);
    if (clock_.now() < due) clock_.sleep_until(due);
    lateness_.add(std::max(0.0, clock_.now() - due));
  }

  // Returns the wall time between two ticks, s; 0 if the pacer never waits.
  double period() const { return period_; }

  // Returns the delays of the ticks: start minus due time. Empty if the pacer never waits.
  const record::Durations& lateness() const { return lateness_; }

 private:
  static constexpr double pause = 0.1;  // s
  WallClock& clock_;
  double period_;
  bool has_started_ = false;
  double start_ = 0.0;  // when tick 0 was due
  record::Durations lateness_;
};

}  // namespace mirocup::pace
