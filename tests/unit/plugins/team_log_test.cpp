// SPDX-License-Identifier: MIT
#include "plugins/host/team_log.hpp"

#include <gtest/gtest.h>

namespace mirocup::plugins {
namespace {

TEST(EscapeUnprintable, KeepsReadableText) {
  EXPECT_EQ(escape_unprintable("plain\ttext\nGrüße 日本 \U0001F916"),
            "plain\ttext\nGrüße 日本 \U0001F916");
}

TEST(EscapeUnprintable, EscapesControlCharacters) {
  EXPECT_EQ(escape_unprintable("\x1b[31m\a\r\x7f"), "\\x1b[31m\\x07\\x0d\\x7f");
  EXPECT_EQ(escape_unprintable("\xc2\x9b"), "\\xc2\\x9b") << "the same as ESC [ in one character";
  EXPECT_EQ(escape_unprintable("\u202e"), "\\xe2\\x80\\xae") << "turns the direction of writing";
}

TEST(EscapeUnprintable, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(escape_unprintable("\xff"), "\\xff");
  EXPECT_EQ(escape_unprintable("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(escape_unprintable("\xc0\xaf"), "\\xc0\\xaf") << "too long a form";
  EXPECT_EQ(escape_unprintable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
}

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
