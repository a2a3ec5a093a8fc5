// SPDX-License-Identifier: MIT
//
// Times in UTC and in zones. Catches an offset that is added where it must be taken off, a day that
// no calendar has, a summer time that begins on another day or ends with the last change that a
// file of the database lists, a zone that is read from another folder.
#include "system/clock.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mirocup::system {
namespace {

std::int64_t utc(std::string_view text) {
  const auto time = parse_time(text);
  EXPECT_TRUE(time) << text;
  return time ? time->at : 0;
}

TEST(Time, IsReadWithAnyOffset) {
  EXPECT_EQ(utc("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(utc("2026-11-30T18:00:00Z"), 1'796'061'600);
  EXPECT_EQ(utc("2026-11-30T19:00:00+01:00"), utc("2026-11-30T18:00:00Z"));
  EXPECT_EQ(utc("2026-11-30T12:30:00-05:30"), utc("2026-11-30T18:00:00Z"));
  EXPECT_TRUE(parse_time("2026-11-30T19:00:00")->is_local);
  EXPECT_EQ(utc_text(utc("2024-02-29T23:59:59Z")), "2024-02-29T23:59:59Z");
  for (const char* bad :
       {"", "2026-02-29T00:00:00Z", "2026-13-01T00:00:00Z", "2026-11-30 18:00:00Z",
        "2026-11-30T24:00:00Z", "2026-11-30T18:00:00z", "2026-11-30T18:00:00+1:00", "2026-11-30",
        "2026-11-31T18:00:00Z", "2026-1-30T018:00:00Z", "2026-11-30T 8:00:00Z",
        "1969-11-30T18:00:00Z", "2026-11-30T18:00:60Z", "2026-11-30T18:00:00+15:00",
        "2026-11-30T18:00:00 01:00", "2026-11-30T18:00:00+01:0", "2026-11-30T18:00:00+01:00Z"})
    EXPECT_FALSE(parse_time(bad)) << bad;
  std::string endless = "2026-11-30T18:00:00";
  for (int i = 0; i < 200'000; ++i) endless += "+01:00:00";
  EXPECT_FALSE(parse_time(endless));
}

TEST(Zone, KnowsSummerAndWinter) {
  const auto berlin = TimeZone::find("Europe/Berlin");
  ASSERT_TRUE(test_support::is_ok(berlin));
  EXPECT_EQ(berlin->text(utc("2026-11-30T18:00:00Z")), "2026-11-30 19:00 CET");
  EXPECT_EQ(berlin->text(utc("2026-07-01T18:00:00Z")), "2026-07-01 20:00 CEST");
  EXPECT_EQ(berlin->text(utc("2026-10-25T00:59:59Z")), "2026-10-25 02:59 CEST");
  EXPECT_EQ(berlin->text(utc("2026-10-25T01:00:00Z")), "2026-10-25 02:00 CET");
  EXPECT_EQ(berlin->date(utc("2026-11-30T23:30:00Z")), "2026-12-01");
  for (const char* shown : {"2026-11-30T19:00:00", "2026-07-01T20:00:00", "2026-10-25T12:00:00"}) {
    const std::int64_t at = berlin->from_local(utc(shown));
    EXPECT_EQ(at + berlin->at(at).seconds, utc(shown)) << shown;
  }
  EXPECT_EQ(TimeZone().text(0), "1970-01-01 00:00 UTC");
  EXPECT_EQ(in_zone(*berlin, "yesterday"), "yesterday");
}

// 02:30 of such a day used to become 01:30, an hour before any reading of it.
TEST(Zone, KnowsHoursThatDoNotExist) {
  const auto berlin = TimeZone::find("Europe/Berlin");
  ASSERT_TRUE(berlin);
  for (const char* shown : {"2027-03-28T02:00:00", "2027-03-28T02:30:00", "2027-03-28T02:59:59"}) {
    const auto gap = berlin->gap_at(utc(shown));
    ASSERT_TRUE(gap) << shown;
    EXPECT_EQ(gap->first, utc("2027-03-28T01:59:59")) << shown;
    EXPECT_EQ(gap->second, utc("2027-03-28T03:00:00")) << shown;
  }
  for (const char* shown : {"2027-03-28T01:59:59", "2027-03-28T03:00:00", "2026-10-25T02:30:00"})
    EXPECT_FALSE(berlin->gap_at(utc(shown))) << shown;
  EXPECT_FALSE(TimeZone().gap_at(0));
  const auto apia = TimeZone::find("Pacific/Apia");
  ASSERT_TRUE(apia);
  const auto day = apia->gap_at(utc("2011-12-30T12:00:00"));
  ASSERT_TRUE(day);
  EXPECT_EQ(day->second, utc("2011-12-31T00:00:00"));
}

TEST(Zone, FollowsTheRuleBehindTheLastChangeOfItsFile) {
  const auto berlin = TimeZone::find("Europe/Berlin");
  ASSERT_TRUE(berlin);
  EXPECT_EQ(berlin->text(utc("2061-07-01T18:00:00Z")), "2061-07-01 20:00 CEST");
  EXPECT_EQ(berlin->text(utc("2061-11-30T18:00:00Z")), "2061-11-30 19:00 CET");
}

// Catches a process and its children that live in the zone of a league from then on.
TEST(Zone, LeavesTheEnvironmentAsItWas) {
  unsetenv("TZ");
  ASSERT_TRUE(TimeZone::find("Asia/Kathmandu"));
  EXPECT_EQ(std::getenv("TZ"), nullptr);
  setenv("TZ", "UTC", 1);
  ASSERT_TRUE(TimeZone::find("Asia/Tokyo"));
  EXPECT_STREQ(std::getenv("TZ"), "UTC");
  unsetenv("TZ");
}

TEST(Zone, IsNoPath) {
  for (const char* bad :
       {"", "../../../etc/passwd", "/etc/localtime", "Europe", "Nowhere/Land", "zone.tab"})
    EXPECT_FALSE(TimeZone::find(bad)) << bad;
}

}  // namespace
}  // namespace mirocup::system
