// SPDX-License-Identifier: MIT
#include "server/dds/liveliness.hpp"

#include <gtest/gtest.h>

namespace mirocup::dds {
namespace {

TEST(Liveliness, ForgivesAShortSilence) {
  Liveliness a(0.3, 10.0);
  a.asked(1.0);
  EXPECT_FALSE(a.silent(5, 1.2, false));
  EXPECT_FALSE(a.answered(5, 1.25));
  a.asked(9.0);  // silence counts from this question on, however long ago the last one was
  EXPECT_FALSE(a.silent(6, 9.2, false));
  EXPECT_TRUE(a.absences().empty());
}

TEST(Liveliness, CountsSilenceFromTheFirstTickWithoutAnswer) {
  Liveliness a(0.3, 10.0);
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
  Liveliness a(0.3, 10.0);
  a.asked(1.0);
  EXPECT_TRUE(a.silent(0, 1.0, true));
  EXPECT_FALSE(a.silent(0, 1.1, true));  // once
  EXPECT_TRUE(a.absences()[0].has_left);
}

TEST(Liveliness, AddsUpAllAbsences) {
  Liveliness a(0.3, 10.0);
  for (int i = 0; i < 3; ++i) {
    a.asked(10.0 * i);
    EXPECT_TRUE(a.silent(2, 10.0 * i, true));
    EXPECT_DOUBLE_EQ(a.away(10.0 * i + 1.0), 2.0 * i + 1.0);
    EXPECT_TRUE(a.answered(2, 10.0 * i + 2.0));
  }
  EXPECT_DOUBLE_EQ(a.away(100.0), 6.0);
  EXPECT_EQ(a.absences().size(), 3U);
}

// Catches a team that answers every tick too late and is taken to be away.
TEST(Liveliness, TakesLateAnswersForASignOfLife) {
  Liveliness a(0.3, 10.0);
  for (std::uint32_t tick = 1; tick < 100; ++tick) {
    const double now = 0.033 * tick;
    a.asked(now);
    EXPECT_FALSE(a.answered_late(tick - 1, tick, now + 0.007));
    EXPECT_FALSE(a.silent(tick, now + 0.03, false)) << tick;
  }
  EXPECT_TRUE(a.absences().empty());
  // From then on it is silent.
  EXPECT_FALSE(a.silent(109, 0.033 * 99 + 0.3, false));
  EXPECT_TRUE(a.silent(109, 0.033 * 99 + 0.31, false));
  EXPECT_EQ(a.absences()[0].tick, 99U);
  EXPECT_TRUE(a.answered_late(108, 110, 4.0));
  EXPECT_EQ(a.absences()[0].back, 110U);
}

// While the match waits for the other team, the answer is asked for again and again. Catches a team
// that dies after it has answered.
TEST(Liveliness, NoticesATeamThatFallsSilentAfterItsAnswer) {
  Liveliness a(1.0, 2.0);
  a.asked(1.0);
  a.answered(7, 1.0);
  a.repeated(1.5);
  EXPECT_FALSE(a.silent(7, 2.4, false));
  EXPECT_TRUE(a.silent(7, 2.6, false));
  EXPECT_EQ(a.absences()[0].tick, 7U);
  EXPECT_EQ(a.absences()[0].noticed, 7U);
  EXPECT_FALSE(a.standing(3.0).seen);
}

TEST(Liveliness, SaysWhenTheLimitIsOver) {
  Liveliness a(0.3, 2.0);
  a.asked(0.0);
  EXPECT_TRUE(a.standing(0.1).seen);
  a.silent(0, 1.0, true);
  EXPECT_FALSE(a.standing(1.0).seen);
  EXPECT_FALSE(a.standing(3.0).lost_at);
  EXPECT_EQ(a.standing(3.1).lost_at, 3.0);
  a.answered(3, 2.5);
  a.asked(2.6);
  EXPECT_EQ(a.standing(2.7).seen, 2.5);
  a.silent(4, 4.0, false);
  EXPECT_EQ(a.standing(5.0).lost_at, 4.5);
  a.answered(9, 6.0);  // too late: it has lost
  EXPECT_EQ(a.standing(7.0).lost_at, 4.5);
}

TEST(Liveliness, KeepsABoundedList) {
  Liveliness a(0.3, 10.0);
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
