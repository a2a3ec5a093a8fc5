// SPDX-License-Identifier: MIT
//
// EXPECT_TRUE(contains(text, part)) prints the text if the part is not in it.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

namespace mirocup::test_support {

inline testing::AssertionResult contains(std::string_view text, std::string_view part) {
  const bool is_found = text.find(part) != std::string_view::npos;
  return testing::AssertionResult(is_found) << '"' << part << "\" is looked for in:\n" << text;
}

}  // namespace mirocup::test_support
