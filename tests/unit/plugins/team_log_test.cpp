// SPDX-License-Identifier: MIT
#include "plugins/host/team_log.hpp"

#include <gtest/gtest.h>

namespace mirocup::plugins {
namespace {

TEST(TeamLog, KeepsTheBeginningAndTheEnd) {
  TeamLog log;
  log.append("begin\n");
  for (int i = 0; i < 100000; ++i) log.append("0123456789\n");
  log.append("end\n");
  const std::string text = log.text();
  EXPECT_LE(text.size(), 65536u);
  EXPECT_EQ(text.rfind("begin\n0123", 0), 0u);
  EXPECT_EQ(text.substr(text.size() - 9), "6789\nend\n");
  EXPECT_NE(text.find("bytes are left out here"), std::string::npos);
}

TEST(TeamLog, StaysBoundedWhenEveryByteIsEscaped) {
  TeamLog log;
  log.append(std::string(1 << 20, '\x1b'));
  EXPECT_LE(log.text().size(), 65536u);
}

// Catches a line with the tick of another one, a tick in the middle of a line, and one that a team
// forges by printing the mark itself.
TEST(TeamLog, KnowsTheTickOfEachLine) {
  TeamLog log;
  log.append("loaded\n");
  log.append("one\ntw", 6);
  log.append("o\n", 7);
  log.append(
      "\x1e"
      "9\x1e"
      "forged\n",
      8);
  EXPECT_EQ(log.text(), "loaded\none\ntwo\n?9?forged\n");
  EXPECT_EQ(log.text(Ticks::shown), "loaded\ntick 6: one\ntick 6: two\ntick 8: ?9?forged\n");
  for (std::uint32_t tick = 0; tick < 30000; ++tick) log.append("0123456789\n", tick);
  EXPECT_LE(log.text().size(), 65536u);
  EXPECT_LE(log.text(Ticks::shown).size(), 131072u);
  EXPECT_TRUE(log.text(Ticks::shown).ends_with("tick 29999: 0123456789\n"));
}

TEST(TeamLog, KeepsAShortLogWhole) {
  TeamLog log;
  log.append("all of it");
  EXPECT_EQ(log.text(), "all of it");
}

}  // namespace
}  // namespace mirocup::plugins
