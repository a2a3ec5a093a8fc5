// SPDX-License-Identifier: MIT
//
// ASSERT_TRUE(is_ok(file)) says why there is no value.
#pragma once

#include "core/base/error.hpp"

#include <gtest/gtest.h>

namespace mirocup::test_support {

template <class T>
testing::AssertionResult is_ok(const Result<T>& result) {
  if (result) return testing::AssertionSuccess();
  return testing::AssertionFailure() << result.error().what;
}

}  // namespace mirocup::test_support
