// SPDX-License-Identifier: MIT
#include "web/http/proxy.hpp"

#include "system/digest.hpp"
#include "web/http/address.hpp"

#include <algorithm>

namespace mirocup::web {

namespace {

constexpr const char* secret_header = "x-mirocup-proxy";

// Returns the last address of a list, which the proxy next to this server has added.
std::string last_of(const std::string& list) {
  const std::size_t comma = list.rfind(',');
  std::string last = comma == std::string::npos ? list : list.substr(comma + 1);
  std::erase_if(last, [](char c) { return c == ' '; });
  return last;
}

bool is_proxy(const ProxyTrust& trust, const Request& request) {
  if (trust.is_unix_socket) return true;
  if (!trust.addresses.contains(request.address)) return false;
  if (trust.secret.empty()) return !is_loopback(request.address);
  // By their hashes, so that the time tells nothing of the secret.
  return system::sha256(request.header(secret_header)) == system::sha256(trust.secret);
}

}  // namespace

bool ProxyTrust::tells_proxies() const {
  return is_unix_socket || !secret.empty() ||
         std::none_of(addresses.begin(), addresses.end(), is_loopback);
}

void apply(const ProxyTrust& trust, Request& request) {
  request.viewer = request.address;
  request.is_from_proxy = is_proxy(trust, request);
  request.headers.erase(secret_header);
  if (!request.is_from_proxy) return;
  if (request.header("x-forwarded-proto") == "https") request.is_encrypted = true;
  const std::string named = last_of(request.header("x-forwarded-for"));
  if (!named.empty()) request.viewer = named;
}

}  // namespace mirocup::web
