// SPDX-License-Identifier: MIT
//
// The address of a server on the command line, and the socket that listens at the address.
#pragma once

#include "core/base/error.hpp"

#include <memory>
#include <netdb.h>
#include <string>

namespace mirocup::web {

// An address such as "8080", "0.0.0.0:8080", "[::1]:8080" or "unix:/run/mirocup/spring.sock".
// Without a host the server accepts only connections from this host. Port 0 is any free port.
struct Address {
  std::string host = "127.0.0.1";
  int port = 0;
  std::string path = {};  // path of a Unix socket; "": the address is host and port
};

// Returns the addresses of a host and port, as getaddrinfo() has them; null if there is no such
// host. `flags`: of addrinfo.
using AddressList = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;
AddressList looked_up(const Address& address, int flags = 0);

// Reads an address. The error (Errc::input) names `option`, the option that gave the text.
Result<Address> parse_address(const std::string& text, const std::string& option);

// Returns the address in the form of a browser; "unix:PATH" for a Unix socket.
std::string url_of(const Address& address, bool is_encrypted);

// Returns the part of an address by which connections are counted. A viewer with IPv6 has 2^64
// addresses, so only the first half of an IPv6 address counts.
std::string counted_address(const std::string& address);

// Returns the address of the other end of a connection, without the zone of IPv6; "" if the
// connection has no address.
std::string address_of_peer(int socket);

// Opens a socket that listens. If the port is 0, fills in the chosen port. A Unix socket belongs to
// this program's user and group, and replaces the file that a dead server has left.
// Errc::unavailable, with the name of `option`, if the address is in use or does not belong to this
// host.
Result<int> open_listener(Address& address, const std::string& option);

}  // namespace mirocup::web
