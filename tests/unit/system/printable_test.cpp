// SPDX-License-Identifier: MIT
//
// Catches text of a stranger that steers a terminal or begins a line of its own.
#include "system/printable.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

TEST(Printable, KeepsReadableText) {
  EXPECT_EQ(printable("plain\ttext\nGrüße 日本 \U0001F916", LineEnds::kept),
            "plain\ttext\nGrüße 日本 \U0001F916");
}

TEST(Printable, CannotBeginALineOfItsOwn) {
  EXPECT_EQ(printable("a fault\n{\"accepted\": true}\r\n"),
            "a fault\\x0a{\"accepted\": true}\\x0d\\x0a");
  EXPECT_EQ(printable("\u2028\u2029\u0085"), "\\xe2\\x80\\xa8\\xe2\\x80\\xa9\\xc2\\x85");
}

TEST(Printable, LeavesWhatItHasEscaped) {
  const std::string once = printable("a\n\xff");
  EXPECT_EQ(printable(once), once);
}

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(printable("\x1b[31m\a\r\x7f"), "\\x1b[31m\\x07\\x0d\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b") << "the same as ESC [ in one character";
  EXPECT_EQ(printable("\u202e"), "\\xe2\\x80\\xae") << "turns the direction of writing";
}

TEST(Printable, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("\xff"), "\\xff");
  EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "too long a form";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
}

TEST(InQuotes, CutsLongTextBetweenCharacters) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "\u00fc";
  const std::string quoted = in_quotes(text);
  EXPECT_EQ(quoted.size(), max_quoted + 5);
  EXPECT_EQ(quoted.substr(quoted.size() - 6), "\u00fc...\"");
  EXPECT_EQ(in_quotes(""), "\"\"");
  EXPECT_EQ(in_quotes("a\tb\n"), "\"a\\tb\\n\"");
}

// Two names that look alike must not pass as two.
TEST(HiddenCharacter, IsFound) {
  EXPECT_EQ(hidden_character("Al\u200bpha"), "U+200B");
  EXPECT_EQ(hidden_character("Alpha\u200d"), "U+200D");
  EXPECT_EQ(hidden_character("\u2060x"), "U+2060");
  EXPECT_EQ(hidden_character("a\u00adb"), "U+00AD");
  for (const char* seen : {"Zoë & Co", "فريق", "می\u200cخواهم", "👩\u200d🚀", "❤\ufe0f", "日本"})
    EXPECT_EQ(hidden_character(seen), "") << seen;
}

}  // namespace
}  // namespace mirocup::system
