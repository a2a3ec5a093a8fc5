// SPDX-License-Identifier: MIT
//
// The address of a server as a person writes it on the command line, and the socket that listens
// there.
#pragma once

#include "core/base/error.hpp"

#include <string>

namespace mirocup::web {

// "8080", "0.0.0.0:8080", "[::1]:8080", "unix:/run/mirocup/spring.sock". Without a host the server
// listens on this host only. Port 0 is any free port.
struct Address {
  std::string host = "127.0.0.1";
  int port = 0;
  std::string path = {};  // of a Unix socket; "": host and port count
};

// `option` names the option that gave the text, for the error (Errc::input).
Result<Address> parse_address(const std::string& text, const std::string& option);

// The address as a browser writes it; "unix:PATH" for a Unix socket.
std::string url_of(const Address& address, bool is_encrypted);

// Returns the address by which connections are counted. A viewer with IPv6 has 2^64 addresses, so
// only the first half of an IPv6 address counts.
std::string counted_address(const std::string& address);

// Returns the address of the other end of a connection, without the zone of IPv6; "" if it has
// none.
std::string address_of_peer(int socket);

// Opens a socket that listens. It fills in the port if that was 0. A Unix socket belongs to this
// program's user and group, and a file that a dead server has left there is replaced.
// Errc::unavailable, with the name of `option`, if the address is in use or not of this host.
Result<int> open_listener(Address& address, const std::string& option);

}  // namespace mirocup::web
