// SPDX-License-Identifier: MIT
//
// Addresses of hosts. Catches an address that the resolver is asked for, a host without an address
// that gets one, and a wait without a limit.
#include "system/host_address.hpp"

#include <gtest/gtest.h>

namespace mirocup::system {
namespace {

TEST(HostAddress, OfAnAddressIsItself) {
  EXPECT_EQ(address_of("10.0.0.5", 0.0).value_or("none"), "10.0.0.5");
}

TEST(HostAddress, OfThisHostIsThatOfTheLoop) {
  EXPECT_EQ(address_of("localhost", 60.0).value_or("none"), "127.0.0.1");
}

TEST(HostAddress, OfAnUnknownHostIsToldInTime) {
  for (const double seconds : {0.0, 60.0}) {
    const auto none = address_of("nosuchhost.invalid", seconds);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, Errc::unavailable);
    EXPECT_EQ(none.error().what.find("nosuchhost.invalid: no address is known"), 0u);
  }
}

}  // namespace
}  // namespace mirocup::system
