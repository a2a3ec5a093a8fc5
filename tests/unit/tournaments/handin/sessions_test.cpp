// SPDX-License-Identifier: MIT
//
// Catches a session that goes on after its end, a cookie that can be read from the disk, and an
// address that tries tokens without a limit or locks out others.
#include "tournaments/handin/sessions.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

constexpr std::int64_t morning = 1'795'000'000;  // s since 1970

TEST(Sessions, LastTwelveHoursOrUntilTheyAreEnded) {
  Sessions sessions;
  const std::string cookie = sessions.begin("hash of a token", morning);
  EXPECT_EQ(sessions.token_of(cookie, morning), "hash of a token");
  EXPECT_EQ(sessions.token_of(cookie, morning + 12 * 3600 - 1), "hash of a token");
  EXPECT_EQ(sessions.token_of(cookie, morning + 12 * 3600), "");
  EXPECT_EQ(sessions.token_of("", morning), "");
  EXPECT_EQ(sessions.token_of(cookie + "A", morning), "");
  sessions.end(cookie);
  EXPECT_EQ(sessions.token_of(cookie, morning), "");
}

TEST(Sessions, AreReadAgainWithoutTheirCookies) {
  Sessions sessions;
  const std::string cookie = sessions.begin("hash", morning);
  EXPECT_EQ(sessions.text().find(cookie), std::string::npos);
  EXPECT_EQ(Sessions::parse(sessions.text()).token_of(cookie, morning), "hash");
  EXPECT_EQ(Sessions::parse("half a file").size(), 0u);
}

TEST(Sessions, OfOneTokenAreBounded) {
  Sessions sessions;
  const std::string other = sessions.begin("other", morning);
  for (int i = 0; i < 1000; ++i) sessions.begin("hash", morning);
  EXPECT_EQ(sessions.size(), 1 + Sessions::max_of_token);
  EXPECT_EQ(sessions.token_of(other, morning), "other") << "one team ends no session of another";
}

TEST(Cookies, AreFoundByTheirWholeNameAndOnlyOnce) {
  EXPECT_EQ(cookie_in("a=1; session=x; b=2", "session"), "x");
  EXPECT_EQ(cookie_in("session=x", "session"), "x");
  EXPECT_EQ(cookie_in("xsession=x; sessionx=y", "session"), "");
  EXPECT_EQ(cookie_in("session=x; session=y", "session"), "") << "nobody chooses between two";
  EXPECT_EQ(cookie_in("session", "session"), "");
  EXPECT_EQ(cookie_in("", "session"), "");
  EXPECT_EQ(cookie_in(";;;=;session=", "session"), "");
}

TEST(WrongTokens, MakeAnAddressWaitLongerAndLonger) {
  WrongTokens wrong;
  std::int64_t now = morning;
  for (int i = 0; i < WrongTokens::free_tries; ++i) EXPECT_EQ(wrong.note("10.0.0.1", now), 0);
  EXPECT_EQ(wrong.note("10.0.0.1", now), 1);
  EXPECT_EQ(wrong.note("10.0.0.1", now), 1) << "who asks while it waits does not wait longer";
  EXPECT_EQ(wrong.note("10.0.0.2", now), 0) << "another address does not wait";
  std::int64_t last = 1;
  for (int i = 0; i < 20; ++i) {
    now += last;
    last = wrong.note("10.0.0.1", now);
  }
  EXPECT_EQ(last, WrongTokens::max_wait);
  EXPECT_EQ(wrong.note("10.0.0.1", now + WrongTokens::forgotten_after + 1), 0);
}

TEST(WrongTokens, CountANetworkOfIpv6AsOne) {
  WrongTokens wrong;
  std::int64_t waits = 0;
  for (int i = 0; i < 10; ++i)
    waits = wrong.note("2001:db8:0:1::" + std::to_string(i + 1), morning);
  EXPECT_GT(waits, 0);
  EXPECT_EQ(wrong.note("2001:db8:0:2::1", morning), 0);
}

TEST(WrongTokens, TakeNoMemoryWithoutEnd) {
  WrongTokens wrong;
  for (int i = 0; i < 20'000; ++i) wrong.note("address " + std::to_string(i), morning);
  EXPECT_LE(wrong.size(), WrongTokens::max_addresses);
  EXPECT_EQ(wrong.note("new", morning + WrongTokens::forgotten_after + 1), 0) << "it forgets";
}

}  // namespace
}  // namespace mirocup::league
