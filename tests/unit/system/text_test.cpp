// SPDX-License-Identifier: MIT
#include "system/text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace mirocup::system {
namespace {

// Catches a replacement that is searched again, which never ends if it contains the word.
TEST(Text, ReplacesEachWordOnce) {
  EXPECT_EQ(replaced("a-a", "a", "aa"), "aa-aa");
  EXPECT_EQ(replaced("abc", "x", "y"), "abc");
  EXPECT_EQ(replaced("@A@@A@", "@A@", ""), "");
}

// Catches a separator before the first word or after the last.
TEST(Text, JoinsWords) {
  EXPECT_EQ(joined(std::vector<std::string>{"a", "b", "c"}, ", "), "a, b, c");
  EXPECT_EQ(joined(std::vector<std::string>{"a"}, ", "), "a");
  EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
}

// Catches a function of the locale, which changes letters beyond ASCII, or "@" and "[" beside A-Z.
TEST(Text, KnowsOnlyLettersOfAscii) {
  EXPECT_EQ(lower_case("AZaz@[\xc3\x84"), "azaz@[\xc3\x84");
  for (const char c : {'a', 'Z', '0', '9', '-', '_', '.'}) EXPECT_TRUE(is_plain(c)) << c;
  for (const char c : {' ', '/', ':', '@', '[', '`', '{', '\0', '\xe4'}) EXPECT_FALSE(is_plain(c));
}

// Catches a text that is cut at the size of a buffer.
TEST(Formatted, IsAsLongAsItsValues) {
  EXPECT_EQ(formatted("%d of %.1f %%", 3, 2.25), "3 of 2.2 %");
  EXPECT_EQ(formatted("%s", ""), "");
  const std::string text(5000, 'x');
  EXPECT_EQ(formatted("<%s>", text.c_str()), "<" + text + ">");
}

// Catches a text that the shell takes apart, expands, or loses, and quotation marks where none are
// needed.
TEST(ShellWord, IsReadAsTheText) {
  EXPECT_EQ(shell_word("/usr/bin/python3"), "/usr/bin/python3");
  EXPECT_EQ(shell_word("its place"), "'its place'");
  EXPECT_EQ(shell_word("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace mirocup::system
