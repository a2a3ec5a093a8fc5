// SPDX-License-Identifier: MIT
//
// Wall time, which the simulation never reads. Tests replace the clock.
#pragma once

#include <chrono>
#include <thread>

namespace mirocup::pace {

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

}  // namespace mirocup::pace
