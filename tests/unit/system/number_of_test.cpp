// SPDX-License-Identifier: MIT
#include "system/number_of.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

// Catches a number that is read from the beginning of a text, and one that wraps around.
TEST(NumberOf, TakesTheWholeText) {
  EXPECT_EQ(number_of<int>("-12"), -12);
  EXPECT_EQ(number_of<double>("2.5e3"), 2500.0);
  for (const char* text : {"", "1x", " 1", "+1", "1 ", "99999999999", "1.5"}) {
    EXPECT_EQ(number_of<int>(text), std::nullopt) << text;
  }
}

// Catches NaN, which every comparison with a limit lets pass.
TEST(NumberOf, IsFinite) {
  EXPECT_EQ(number_of<double>("1e308"), 1e308);
  for (const char* text : {"nan", "-nan", "nan(3)", "NAN", "inf", "-inf", "infinity", "1e999",
                           "-1e999", "0x1p3", " 5", "5 ", "+5", "1e", ""}) {
    EXPECT_EQ(number_of<double>(text), std::nullopt) << text;
  }
}

TEST(NumberOf, ReadsHexadecimalDigits) {
  EXPECT_EQ(hexadecimal_of<unsigned>("00fF"), 255u);
  for (const char* text : {"", "0x1", "-1", "fg", "100000000"}) {
    EXPECT_EQ(hexadecimal_of<unsigned>(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace mirocup::system
