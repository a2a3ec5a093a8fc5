// SPDX-License-Identifier: MIT
//
// Where a server listens, as a person writes it.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::web {

// "8080", "0.0.0.0:8080", "[::1]:8080"; without a host this host only, port 0: any that is free.
struct Address {
  std::string host = "127.0.0.1";
  int port = 0;
};

// `option` is the one that has the text, for the error (Errc::input).
Result<Address> parse_address(const std::string& text, const std::string& option);

}  // namespace mirocup::web
