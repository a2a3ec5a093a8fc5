// SPDX-License-Identifier: MIT
//
// Catches a log that loses the reason why a team could not join, because strangers made Cyclone log
// other messages.
#include "server/dds/cyclone_log.hpp"

#include <dds/ddsrt/log.h>
#include <gtest/gtest.h>

#include <string>

namespace mirocup::dds {
namespace {

// Logs a message as Cyclone does.
void say(const std::string& text) {
  dds_log(DDS_LC_WARNING, __FILE__, __LINE__, __func__, "%s\n", text.c_str());
}

TEST(CycloneLog, KeepsTheLastDifferentMessages) {
  const CycloneLog log;
  EXPECT_EQ(log.last_error(), "");
  EXPECT_EQ(log.last_error_suffix(), "");
  for (const char* text : {"one", "two", "three", "two", "four", "five", "five"}) {
    say(text);
  }
  EXPECT_EQ(log.last_error(), "three; two; four; five");
}

TEST(CycloneLog, IsNotFloodedWithMalformedPackets) {
  const CycloneLog log;
  say("malformed packet 1");
  EXPECT_EQ(log.last_error(), "malformed packet 1");
  EXPECT_EQ(log.last_error_suffix(), " (DDS: malformed packet 1)");
  say("certificate revoked");
  for (int i = 2; i < 10; ++i) say("malformed packet " + std::to_string(i));
  EXPECT_EQ(log.last_error(), "certificate revoked");
}

// Other matches and leagues on the same host cause messages, each with a number or a name of its
// own.
TEST(CycloneLog, KeepsTheTeamsOwnErrorAmongManyStrangers) {
  const CycloneLog log;
  say("certificate revoked; subject: team ours");
  for (int i = 0; i < 10; ++i) {
    const std::string number = std::to_string(i);
    say("Remote secure participant " + number + ":1c1 not allowed");
    say("error: certificate signature failure; subject: team " + number);
  }
  EXPECT_EQ(log.last_error(),
            "certificate revoked; subject: team ours; Remote secure participant 9:1c1 not allowed; "
            "error: certificate signature failure; subject: team 9");
  for (const char* text : {"one", "two", "three"}) say(text);
  EXPECT_EQ(log.last_error(), "certificate revoked; subject: team ours; one; two; three");
}

TEST(CycloneLog, IsPrintableAndShort) {
  const CycloneLog log;
  say("a\x1b[31m");
  say(std::string(5000, 'x'));
  EXPECT_LT(log.last_error().size(), 400U);
  EXPECT_EQ(log.last_error().substr(0, 6), "a?[31m");
}

}  // namespace
}  // namespace mirocup::dds
