// SPDX-License-Identifier: MIT
//
// Catches a program of this computer that passes for the proxy, and a viewer that invents an
// address.
#include "web/http/address.hpp"
#include "web/http/server.hpp"

#include <gtest/gtest.h>

namespace mirocup::web {
namespace {

Request from(const std::string& address, const std::string& secret = "") {
  Request request{.method = "GET", .path = "/", .address = address};
  request.headers = {{"x-forwarded-for", "10.9.9.9, 10.7.7.7"}, {"x-forwarded-proto", "https"}};
  if (!secret.empty()) request.headers.emplace("x-mirocup-proxy", secret);
  return request;
}

std::string viewer(const ProxyTrust& trust, Request request) {
  apply(trust, request);
  EXPECT_EQ(request.is_from_proxy, request.viewer != request.address);
  EXPECT_EQ(request.is_encrypted, request.is_from_proxy);
  EXPECT_FALSE(request.headers.contains("x-mirocup-proxy")) << "no page shows it";
  return request.viewer;
}

TEST(ProxyTrust, TellsAProxyFromALocalUser) {
  const std::string secret = "0123456789abcdef";
  EXPECT_EQ(viewer({}, from("10.0.0.2")), "10.0.0.2");
  EXPECT_EQ(viewer({.secret = secret}, from("10.0.0.2", secret)), "10.0.0.2");
  // A user of the proxy's computer has its address, too, and the proxy's computer may be this one.
  for (const char* address : {"10.0.0.2", "127.0.0.1", "127.1.2.3", "::1"}) {
    const ProxyTrust trust{.addresses = {address}, .secret = secret};
    EXPECT_EQ(viewer(trust, from(address, secret)), "10.7.7.7");
    EXPECT_EQ(viewer(trust, from(address, "other")), address);
    EXPECT_EQ(viewer(trust, from(address)), address);
    EXPECT_EQ(viewer(trust, from("10.0.0.3", secret)), "10.0.0.3");
    EXPECT_EQ(viewer({.addresses = {address}}, from(address)), address) << "without a secret";
    Request empty = from(address);
    empty.headers.emplace("x-mirocup-proxy", "");
    EXPECT_EQ(viewer({.addresses = {address}}, empty), address) << "without a secret";
  }
  EXPECT_EQ(viewer({.is_unix_socket = true}, from("")), "10.7.7.7");
  Request twice = from("127.0.0.1", secret);
  twice.headers.emplace("x-mirocup-proxy", secret);
  EXPECT_EQ(viewer({.addresses = {"127.0.0.1"}, .secret = secret}, twice), "127.0.0.1");
}

TEST(Addresses, AreCountedByTheNetworkOfOneViewer) {
  EXPECT_EQ(counted_address("10.0.0.1"), "10.0.0.1");
  EXPECT_EQ(counted_address("2001:db8:1:2:3:4:5:6"), counted_address("2001:db8:1:2:9::1"));
  EXPECT_NE(counted_address("2001:db8:1:2::1"), counted_address("2001:db8:1:3::1"));
  EXPECT_EQ(counted_address("no address"), "no address");
}

TEST(Addresses, MayBeAUnixSocket) {
  EXPECT_EQ(parse_address("unix:/run/x", "--at")->path, "/run/x");
  EXPECT_FALSE(parse_address("unix:", "--at"));
  EXPECT_FALSE(parse_address("unix:" + std::string(108, 'x'), "--at"));
  EXPECT_EQ(url_of({.path = "/run/x"}, false), "unix:/run/x");
  EXPECT_EQ(url_of({.host = "::1", .port = 8}, true), "https://[::1]:8/");
}

}  // namespace
}  // namespace mirocup::web
