// SPDX-License-Identifier: MIT
//
// The address of a server as a person writes it on the command line.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::web {

// "8080", "0.0.0.0:8080", "[::1]:8080". Without a host the server listens on this host only. Port 0
// is any free port.
struct Address {
  std::string host = "127.0.0.1";
  int port = 0;
};

// `option` names the option that gave the text, for the error (Errc::input).
Result<Address> parse_address(const std::string& text, const std::string& option);

}  // namespace mirocup::web
