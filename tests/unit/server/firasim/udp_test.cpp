// SPDX-License-Identifier: MIT
#include "server/firasim/udp.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace mirocup::firasim {
namespace {

// A socket as a client has one: bound to the group or to any address, joined on an interface of the
// host or on none. Without a port: one that is free.
system::Descriptor listener(std::uint32_t bound_to, const char* interface, std::uint16_t& port) {
  system::Descriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int on = 1;
  setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(bound_to);
  at.sin_port = htons(port);
  socklen_t length = sizeof at;
  if (bind(socket.get(), reinterpret_cast<const sockaddr*>(&at), length) != 0) abort();
  getsockname(socket.get(), reinterpret_cast<sockaddr*>(&at), &length);
  port = ntohs(at.sin_port);
  if (interface != nullptr) {
    ip_mreq group{};
    inet_pton(AF_INET, "239.255.7.7", &group.imr_multiaddr);
    inet_pton(AF_INET, interface, &group.imr_interface);
    // Without a default route there is no interface for 0.0.0.0; then it has joined nowhere.
    setsockopt(socket.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group);
  }
  return socket;
}

int copies(const system::Descriptor& socket) {
  int count = 0;
  char buffer[64];
  while (recv(socket.get(), buffer, sizeof buffer, 0) > 0) ++count;
  return count;
}

// Catches a client that hears each vision twice, because it is sent on two interfaces, or never,
// because it joined on another one: the first answers twice, the second not at all.
TEST(FirasimUdp, EachListenerOfAGroupHearsADatagramOnce) {
  constexpr std::uint32_t group = 0xefff0707;  // 239.255.7.7
  std::uint16_t port = 0;
  const auto on_lo = listener(group, "127.0.0.1", port);
  const auto by_default = listener(group, "0.0.0.0", port);
  const auto anywhere = listener(0, "0.0.0.0", port);
  const auto nowhere = listener(group, nullptr, port);
  const auto sender = Sender::open({Endpoint{group, port}}, this_host);
  ASSERT_TRUE(sender);
  sender->send("vision");
  EXPECT_EQ(copies(on_lo), 1);
  EXPECT_EQ(copies(by_default), 1);
  EXPECT_EQ(copies(anywhere), 1);
  EXPECT_EQ(copies(nowhere), 1);
}

}  // namespace
}  // namespace mirocup::firasim
