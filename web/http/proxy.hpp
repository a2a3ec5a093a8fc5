// SPDX-License-Identifier: MIT
//
// The proxies between this server and its viewers: how the server knows them, and which of their
// headers it trusts.
#pragma once

#include "web/http/request.hpp"

#include <set>
#include <string>

namespace mirocup::web {

// By default there are none.
struct ProxyTrust {
  std::set<std::string> addresses = {};

  // The value that these proxies send in the header X-Mirocup-Proxy. An address alone proves
  // nothing, because each program of a computer has it. "": there are no proxies.
  std::string secret = {};

  // True if this server listens at a Unix socket: any program that may open it counts as the proxy.
  bool is_unix_socket = false;
};

// Finds out whether the request comes from a proxy, and for which viewer (X-Forwarded-For,
// X-Forwarded-Proto).
void apply(const ProxyTrust& trust, Request& request);

}  // namespace mirocup::web
