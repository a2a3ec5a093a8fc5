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

TEST(TeamLog, KeepsAShortLogWhole) {
  TeamLog log;
  log.append("all of it");
  EXPECT_EQ(log.text(), "all of it");
}

}  // namespace
}  // namespace mirocup::plugins
