// SPDX-License-Identifier: MIT
#include "server/firasim/udp.hpp"

#include "system/number_of.hpp"

#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <net/if.h>
#include <netinet/in.h>
#include <sstream>
#include <sys/socket.h>

namespace mirocup::firasim {

namespace {

sockaddr_in to_sockaddr(const Endpoint& endpoint) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(endpoint.address);
  address.sin_port = htons(endpoint.port);
  return address;
}

Endpoint to_endpoint(const sockaddr_in& address) {
  return {ntohl(address.sin_addr.s_addr), ntohs(address.sin_port)};
}

template <class T>
bool set(int socket, int level, int option, const T& value) {
  return setsockopt(socket, level, option, &value, sizeof value) == 0;
}

// The indexes of the interfaces for groups; 0 is that of the default route.
Result<std::vector<int>> indexes_of(const std::string& interface) {
  const int lo = static_cast<int>(if_nametoindex(this_host));
  if (interface == this_host) return std::vector<int>{lo, 0};
  const int index = static_cast<int>(if_nametoindex(interface.c_str()));
  if (index == 0) {
    return fail(Errc::unavailable, "--interface " + interface + ": there is no such interface");
  }
  return std::vector<int>{index, lo};
}

// Joins a group on all interfaces of a list that have it; false if none has.
bool join(int socket, std::uint32_t group, const std::vector<int>& interfaces) {
  bool has_joined = false;
  for (const int index : interfaces) {
    const ip_mreqn request{
        .imr_multiaddr = to_sockaddr({group, 0}).sin_addr, .imr_address = {}, .imr_ifindex = index};
    has_joined = set(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, request) || has_joined;
  }
  return has_joined;
}

}  // namespace

std::string to_text(const Endpoint& endpoint) {
  std::array<char, INET_ADDRSTRLEN> text{};
  const in_addr address{htonl(endpoint.address)};
  inet_ntop(AF_INET, &address, text.data(), text.size());
  return std::string(text.data()) + ":" + std::to_string(endpoint.port);
}

bool is_of_this_host(const Endpoint& endpoint) {
  if (endpoint.address >> IN_CLASSA_NSHIFT == IN_LOOPBACKNET) return true;
  // Only a host's own addresses can be bound to.
  const system::Descriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const sockaddr_in own = to_sockaddr({endpoint.address, 0});
  return bind(socket.get(), reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0;
}

Result<Endpoint> parse_endpoint(const std::string& text, const std::string& option) {
  const auto bad = [&] {
    return fail(Errc::input,
                option + " " + text + ": ADDRESS:PORT is expected, as in 224.0.0.1:10002");
  };
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return bad();
  in_addr address{};
  if (inet_pton(AF_INET, text.substr(0, colon).c_str(), &address) != 1) return bad();
  const auto port = system::number_of<std::uint16_t>(text.substr(colon + 1));
  if (!port || *port == 0) return bad();
  return Endpoint{ntohl(address.s_addr), *port};
}

Result<std::vector<Endpoint>> parse_endpoints(const std::string& text, const std::string& option) {
  std::vector<Endpoint> endpoints;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    MIROCUP_TRY(const auto endpoint, parse_endpoint(word, option));
    endpoints.push_back(endpoint);
  }
  if (endpoints.empty()) return fail(Errc::input, option + ": at least one address is expected");
  return endpoints;
}

Result<Sender> Sender::open(std::vector<Endpoint> to, const std::string& interface) {
  MIROCUP_TRY(const auto indexes, indexes_of(interface));
  Sender sender;
  sender.to_ = std::move(to);
  sender.socket_.reset(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!sender.socket_.is_open()) {
    return fail(Errc::unavailable, std::string("no UDP socket: ") + std::strerror(errno));
  }
  const int socket = sender.socket_.get();
  const int index = indexes.front();
  const int ttl = interface == this_host ? 0 : 1;
  set(socket, IPPROTO_IP, IP_MULTICAST_TTL, ttl);
  const ip_mreqn way{.imr_multiaddr = {}, .imr_address = {}, .imr_ifindex = index};
  set(socket, IPPROTO_IP, IP_MULTICAST_IF, way);
  for (const Endpoint& endpoint : sender.to_) {
    if (!endpoint.is_group()) continue;
    join(socket, endpoint.address, {index});
  }
  return sender;
}

void Sender::send(const std::string& bytes) const {
  for (const Endpoint& endpoint : to_) {
    const sockaddr_in address = to_sockaddr(endpoint);
    sendto(socket_.get(), bytes.data(), bytes.size(), 0,
           reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }
}

Result<Receiver> Receiver::open(const Endpoint& at, const std::string& interface,
                                const std::string& option) {
  Receiver receiver;
  receiver.socket_.reset(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int socket = receiver.socket_.get();
  // A group may have other listeners, such as a second referee; an own address has none.
  if (at.is_group()) set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
  set(socket, SOL_SOCKET, SO_RCVBUF, 1 << 20);
  const sockaddr_in address = to_sockaddr(at);
  if (bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return fail(Errc::unavailable, option + " " + to_text(at) + ": " + std::strerror(errno) +
                                       (errno == EADDRINUSE ? " (by another match?)" : ""));
  MIROCUP_TRY(const auto indexes, indexes_of(interface));
  if (!at.is_group()) {
    if (at.address == INADDR_ANY) join(socket, INADDR_ALLHOSTS_GROUP, indexes);
    // From now on, for only_from(). A match that opens the same address does not ask to share it,
    // and is refused.
    set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
    return receiver;
  }
  if (!join(socket, at.address, indexes))
    return fail(Errc::unavailable, option + " " + to_text(at) +
                                       ": the group cannot be joined: " + std::strerror(errno));
  return receiver;
}

Result<Receiver> Receiver::only_from(const Endpoint& peer) const {
  sockaddr_in own{};
  socklen_t length = sizeof own;
  const sockaddr_in other = to_sockaddr(peer);
  Receiver receiver;
  receiver.socket_.reset(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int socket = receiver.socket_.get();
  set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
  set(socket, SOL_SOCKET, SO_RCVBUF, 1 << 20);
  if (getsockname(descriptor(), reinterpret_cast<sockaddr*>(&own), &length) != 0 ||
      bind(socket, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0 ||
      connect(socket, reinterpret_cast<const sockaddr*>(&other), sizeof other) != 0) {
    return fail(Errc::unavailable, "no socket for " + to_text(peer) + ": " + std::strerror(errno));
  }
  return receiver;
}

bool Receiver::receive(Datagram& datagram) const {
  std::array<char, max_size> buffer;
  sockaddr_in from{};
  socklen_t length = sizeof from;
  const ssize_t size =
      TEMP_FAILURE_RETRY(recvfrom(socket_.get(), buffer.data(), buffer.size(), MSG_TRUNC,
                                  reinterpret_cast<sockaddr*>(&from), &length));
  if (size < 0) return false;
  datagram.from = to_endpoint(from);
  datagram.bytes.assign(buffer.data(), static_cast<std::size_t>(size) > max_size
                                           ? 0
                                           : static_cast<std::size_t>(size));
  return true;
}

}  // namespace mirocup::firasim
