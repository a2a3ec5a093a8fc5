// SPDX-License-Identifier: MIT
//
// Catches a digest or an encoding that other programs do not compute. The digests are those of
// FIPS 180-4 and of `openssl dgst -sha256 -binary | base64`.
#include "system/digest.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

TEST(Digest, IsTheOneOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_base64("abc"), "ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

TEST(Base64, PadsToFourDigits) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("a"), "YQ==");
  EXPECT_EQ(base64("ab"), "YWI=");
  EXPECT_EQ(base64("abc"), "YWJj");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace mirocup::system
