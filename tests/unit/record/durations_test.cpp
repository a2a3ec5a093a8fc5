// SPDX-License-Identifier: MIT
//
// Catches a histogram that loses very short or long durations, and percentiles that are too small.
#include "record/durations.hpp"

#include <gtest/gtest.h>

namespace mirocup::record {
namespace {

TEST(Durations, QuantilesAreAtMostOneThirtySecondTooLong) {
  Durations durations;
  for (int i = 1; i <= 1000; ++i) durations.add(1e-5 * i);
  for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999}) {
    EXPECT_GE(durations.quantile(share), 1e-2 * share) << share;
    EXPECT_LE(durations.quantile(share), (1.0 + 1.0 / 32) * 1e-2 * share + 1e-12) << share;
  }
  EXPECT_DOUBLE_EQ(durations.quantile(1.0), 1e-2);
  EXPECT_DOUBLE_EQ(durations.max(), 1e-2);
}

TEST(Durations, AreAllCounted) {
  Durations durations;
  for (const double seconds : {0.0, 1e-9, 1e-6, 0.033, 0.033, 5.0, 1e5}) durations.add(seconds);
  EXPECT_EQ(durations.count(), 7U);
  EXPECT_LT(durations.quantile(2.0 / 7.0), 1e-6);
  EXPECT_DOUBLE_EQ(durations.max(), 1e5);
  std::uint64_t count = 0;
  double before = 0.0;
  for (const auto& range : durations.histogram()) {
    EXPECT_GT(range.below, before);
    before = range.below;
    count += range.count;
  }
  EXPECT_EQ(count, 7U);
}

// A bound belongs to the range above it, as schema.md says.
TEST(Durations, CountInTheRangeBelowTheirBound) {
  for (double seconds = 1.1e-6; seconds < 100.0; seconds *= 1.07) {
    Durations durations;
    durations.add(seconds);
    const double below = durations.histogram().at(0).below;
    EXPECT_LT(seconds, below);
    EXPECT_GE(seconds, below / 2.0);
    Durations bound;
    bound.add(below);
    EXPECT_GT(bound.histogram().at(0).below, below);
  }
}

TEST(Durations, AreZeroWithoutSamples) {
  const Durations none;
  EXPECT_EQ(none.quantile(0.5), 0.0);
  EXPECT_TRUE(none.histogram().empty());
}

}  // namespace
}  // namespace mirocup::record
