// SPDX-License-Identifier: MIT
//
// The proxies between this server and its viewers: how the server recognises a proxy, and which
// headers of a proxy it trusts.
#pragma once

#include "web/http/request.hpp"

#include <set>
#include <string>

namespace mirocup::web {

// The trusted proxies; by default none.
struct ProxyTrust {
  std::set<std::string> addresses = {};

  // The value that trusted proxies send in the header X-Mirocup-Proxy. An address alone proves
  // nothing, because all programs of a computer share it. "": there are no proxies.
  std::string secret = {};

  // True if this server listens at a Unix socket: any program that may open it counts as the proxy.
  bool is_unix_socket = false;
};

// Finds out whether the request comes from a trusted proxy, and for which viewer (X-Forwarded-For,
// X-Forwarded-Proto).
void apply(const ProxyTrust& trust, Request& request);

}  // namespace mirocup::web
