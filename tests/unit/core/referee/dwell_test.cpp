// SPDX-License-Identifier: MIT
//
// Catches a limit that is reached a sample early or late, and time that survives a break.
#include "core/referee/dwell.hpp"

#include <gtest/gtest.h>

namespace mirocup::referee {
namespace {

constexpr double duration = 0.033;

TEST(DwellTimer, ALimitIsReachedAtTheSampleNearestToIt) {
  Dwell dwell;
  int samples = 0;
  while (samples < 100 && !dwell.reached(0.5, duration)) {
    dwell.sample(true, duration);
    ++samples;
  }
  EXPECT_EQ(samples, 16) << "the first counts as 0 s, 15 more are 0.495 s";
}

TEST(DwellTimer, ABreakStartsTheTimeAgain) {
  Dwell dwell;
  for (int i = 0; i < 100; ++i) dwell.sample(true, duration);
  dwell.sample(false, duration);
  EXPECT_FALSE(dwell.reached(0.0, duration));
  dwell.sample(true, duration);
  EXPECT_EQ(dwell.for_s, 0.0);
}

TEST(DwellTimer, ALimitOfZeroIsReachedAtOnceOnlyWhileTheConditionHolds) {
  Dwell dwell;
  EXPECT_FALSE(dwell.reached(0.0, duration));
  dwell.sample(true, duration);
  EXPECT_TRUE(dwell.reached(0.0, duration));
}

}  // namespace
}  // namespace mirocup::referee
