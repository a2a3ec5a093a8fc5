// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"

#include <gtest/gtest.h>

namespace mirocup::dds {
namespace {

TEST(Liveliness, ForgivesAShortSilence) {
  Liveliness a(0.3);
  a.asked(1.0);
  EXPECT_FALSE(a.silent(5, 1.2, false));
  EXPECT_FALSE(a.answered(5, 1.25));
  a.asked(9.0);  // silence counts from this question on, however long ago the last one was
  EXPECT_FALSE(a.silent(6, 9.2, false));
  EXPECT_TRUE(a.absences().empty());
}

TEST(Liveliness, CountsSilenceFromTheFirstTickWithoutAnswer) {
  Liveliness a(0.3);
  a.asked(1.0);
  a.answered(4, 1.0);
  for (int i = 0; i < 10; ++i) {
    const double now = 1.0 + 0.033 * i;
    a.asked(now);
    const bool noticed = a.silent(5 + static_cast<std::uint32_t>(i), now + 0.03, false);
    EXPECT_EQ(noticed, i == 9) << i;  // 0.297 s + 0.03 s
  }
  ASSERT_EQ(a.absences().size(), 1U);
  EXPECT_EQ(a.absences()[0].tick, 5U);
  EXPECT_EQ(a.absences()[0].noticed, 14U);
  EXPECT_FALSE(a.absences()[0].back);
}

TEST(Liveliness, NoticesAtOnceThatAProcessHasLeft) {
  Liveliness a(0.3);
  a.asked(1.0);
  EXPECT_TRUE(a.silent(0, 1.0, true));
  EXPECT_FALSE(a.silent(0, 1.1, true));  // once
  EXPECT_TRUE(a.absences()[0].has_left);
}

TEST(Liveliness, AddsUpAllAbsences) {
  Liveliness a(0.3);
  for (int i = 0; i < 3; ++i) {
    a.asked(10.0 * i);
    EXPECT_TRUE(a.silent(2, 10.0 * i, true));
    EXPECT_DOUBLE_EQ(a.away(10.0 * i + 1.0), 2.0 * i + 1.0);
    EXPECT_TRUE(a.answered(2, 10.0 * i + 2.0));
  }
  EXPECT_DOUBLE_EQ(a.away(100.0), 6.0);
  EXPECT_EQ(a.absences().size(), 3U);
}

TEST(Liveliness, KeepsABoundedList) {
  Liveliness a(0.3);
  for (int i = 0; i < 1000; ++i) {
    a.asked(i);
    a.silent(0, i, true);
    a.answered(0, i + 0.5);
  }
  EXPECT_EQ(a.absences().size(), 100U);
  EXPECT_DOUBLE_EQ(a.away(1000.0), 500.0);
}

}  // namespace
}  // namespace mirocup::dds
