// SPDX-License-Identifier: MIT
#include "system/shell_word.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

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
