// SPDX-License-Identifier: MIT
//
// Catches a digest, a page and a command that mean different moments by the same words.
#include "record/clock_words.hpp"

#include <gtest/gtest.h>

namespace mirocup::record {
namespace {

TEST(ClockWords, AreReadAsTheyAreWritten) {
  for (const auto phase : {referee::Phase::FIRST_HALF, referee::Phase::SECOND_HALF,
                           referee::Phase::EXTRA, referee::Phase::SHOOT_OUT})
    for (const double clock : {0.0, 9.0, 59.0, 60.0, 3599.0}) {
      const ClockTime time{phase, clock};
      EXPECT_EQ(clock_time_of(in_words(time)), time) << in_words(time);
    }
  EXPECT_EQ(in_words({referee::Phase::SECOND_HALF, 70.9}), "second half 1:10");
  EXPECT_LT(*clock_time_of("first half 59:59"), *clock_time_of("Second half 0:00"));
  for (const char* wrong : {"", "second half", "second half 1", "second half 1:60", "half 1:00",
                            "second half -1:00", "second half 1:2x", "second half  1:00"})
    EXPECT_FALSE(clock_time_of(wrong)) << wrong;
}

}  // namespace
}  // namespace mirocup::record
