// SPDX-License-Identifier: MIT
#include "system/command_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace mirocup::system {
namespace {

// Catches a guess that is far from what was typed, and two exchanged letters that count twice.
TEST(ClosestWord, IsAtMostTwoSlipsAway) {
  const std::vector<std::string> words{"match", "check", "verify", "replay", "new"};
  EXPECT_EQ(closest_word("mach", words), "match");
  EXPECT_EQ(closest_word("vefiry", words), "verify");
  EXPECT_EQ(closest_word("rpelay", words), "replay");
  EXPECT_EQ(closest_word("match", words), "match");
  EXPECT_EQ(closest_word("tournament", words), "");
  EXPECT_EQ(closest_word("ne", words), "") << "too short for a guess";
  EXPECT_EQ(closest_word("", words), "");
}

TEST(Seed, IsAnIntegerOfSixtyFourBits) {
  EXPECT_EQ(problem_with_seed("0"), "");
  EXPECT_EQ(problem_with_seed("18446744073709551615"), "");
  for (const char* bad : {"", "-1", "+1", "1.0", "1e3", "18446744073709551616", "seed"})
    EXPECT_NE(problem_with_seed(bad), "") << bad;
}

}  // namespace
}  // namespace mirocup::system
