// SPDX-License-Identifier: MIT
#include "system/formatted.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

// Catches a text that is cut at the size of a buffer.
TEST(Formatted, IsAsLongAsItsValues) {
  EXPECT_EQ(formatted("%d of %.1f %%", 3, 2.25), "3 of 2.2 %");
  EXPECT_EQ(formatted("%s", ""), "");
  const std::string text(5000, 'x');
  EXPECT_EQ(formatted("<%s>", text.c_str()), "<" + text + ">");
}

}  // namespace
}  // namespace mirocup::system
