// SPDX-License-Identifier: MIT
//
// Catches a clock that drifts with the time that ticks take, and one that runs at the wrong speed.
#include "server/pace/pacer.hpp"

#include <gtest/gtest.h>

namespace mirocup::pace {
namespace {

class FakeClock final : public WallClock {
 public:
  double now() override { return time; }
  void sleep_until(double until) override {
    EXPECT_GT(until, time);
    time = until;
  }
  double time = 100.0;
};

TEST(Pacer, KeepsTimeHoweverLongTicksTake) {
  FakeClock clock;
  Pacer pacer(clock, 0.033, 1.0);
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    pacer.wait_for(tick);
    EXPECT_NEAR(clock.time, 100.0 + 0.033 * tick, 1e-9);
    clock.time += tick % 10 == 0 ? 0.020 : 0.001;
  }
}

TEST(Pacer, CatchesUpAfterALateTick) {
  FakeClock clock;
  Pacer pacer(clock, 0.033, 1.0);
  pacer.wait_for(0);
  clock.time += 0.2;  // six ticks late
  pacer.wait_for(1);
  EXPECT_NEAR(clock.time, 100.2, 1e-9);
  int calls = 0;
  pacer.wait_for(10, [&calls] { ++calls; });
  EXPECT_NEAR(clock.time, 100.33, 1e-9);
  EXPECT_EQ(calls, 1);  // ten times a second
}

TEST(Pacer, CountsHowLateTicksBegin) {
  FakeClock clock;
  Pacer pacer(clock, 0.033, 1.0);
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    pacer.wait_for(tick);
    clock.time += tick == 500 ? 0.043 : 0.001;
  }
  EXPECT_EQ(pacer.lateness().count(), 1000U);
  EXPECT_NEAR(pacer.lateness().max(), 0.010, 1e-9);
  EXPECT_LT(pacer.lateness().quantile(0.999), 1e-6);
}

TEST(Pacer, PlaysFasterByAFactorOrWithoutWaiting) {
  FakeClock clock;
  Pacer faster(clock, 0.033, 4.0);
  for (std::uint32_t tick = 0; tick <= 100; ++tick) faster.wait_for(tick);
  EXPECT_NEAR(clock.time, 100.0 + 100 * 0.033 / 4.0, 1e-9);
  Pacer fastest(clock, 0.033, std::nullopt);
  for (std::uint32_t tick = 0; tick <= 100; ++tick) fastest.wait_for(tick);
  EXPECT_NEAR(clock.time, 100.0 + 100 * 0.033 / 4.0, 1e-9);
}

}  // namespace
}  // namespace mirocup::pace
