// SPDX-License-Identifier: MIT
//
// The proxies between this server and its viewers: how they are told from other programs, and what
// they are believed.
#pragma once

#include "web/http/request.hpp"

#include <set>
#include <string>

namespace mirocup::web {

// By default there are none.
struct ProxyTrust {
  std::set<std::string> addresses = {};

  // What these proxies send in the header X-Mirocup-Proxy. An address alone proves nothing, because
  // each program of a computer has it. "": there are no proxies.
  std::string secret = {};

  // This server listens at a Unix socket: who may open that is the proxy.
  bool is_unix_socket = false;
};

// Finds out whether the request comes from a proxy, and for whom (X-Forwarded-For,
// X-Forwarded-Proto).
void apply(const ProxyTrust& trust, Request& request);

}  // namespace mirocup::web
