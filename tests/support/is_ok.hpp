// SPDX-License-Identifier: MIT
//
// ASSERT_TRUE(is_ok(file)) says why there is no value.
#pragma once

#include "core/base/error.hpp"
#include "tests/support/contains.hpp"

#include <gtest/gtest.h>

#include <string>

namespace mirocup::test_support {

// Returns the sentence of the error, and "" if there is a value.
template <class T>
std::string why_not(const Result<T>& result) {
  return result ? "" : result.error().what;
}

template <class T>
testing::AssertionResult is_ok(const Result<T>& result) {
  return testing::AssertionResult(result.has_value()) << why_not(result);
}

}  // namespace mirocup::test_support
