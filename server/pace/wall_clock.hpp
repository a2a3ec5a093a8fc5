// SPDX-License-Identifier: MIT
//
// Wall time, for those rooms that may know it. Tests put a clock of their own behind it.
#pragma once

#include <chrono>
#include <thread>

namespace mirocup::pace {

class WallClock {
 public:
  virtual ~WallClock() = default;
  virtual double now() = 0;  // s, never goes back
  virtual void sleep_until(double time) = 0;
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
