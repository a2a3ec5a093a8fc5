// SPDX-License-Identifier: MIT
//
// Catches a secret that is taken for another one.
#include "system/secret.hpp"

#include <gtest/gtest.h>

#include <string>

namespace mirocup::system {
namespace {

TEST(Secret, IsTheSameInEachCharacterOnly) {
  const std::string secret = "abc\xff\0z";
  EXPECT_TRUE(is_same_secret(secret, secret));
  EXPECT_TRUE(is_same_secret("", ""));
  for (std::size_t i = 0; i < secret.size(); ++i) {
    std::string other = secret;
    other[i] = static_cast<char>(other[i] ^ '\x80');
    EXPECT_FALSE(is_same_secret(secret, other)) << i;
    EXPECT_FALSE(is_same_secret(secret, secret.substr(0, i)));
    EXPECT_FALSE(is_same_secret(secret.substr(0, i), secret));
  }
}

}  // namespace
}  // namespace mirocup::system
