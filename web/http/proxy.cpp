// SPDX-License-Identifier: MIT
#include "web/http/proxy.hpp"

#include "system/digest.hpp"

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
  if (trust.secret.empty() || !trust.addresses.contains(request.address)) return false;
  // By their hashes, so that the time tells nothing of the secret.
  return system::sha256(request.header(secret_header)) == system::sha256(trust.secret);
}

}  // namespace

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
