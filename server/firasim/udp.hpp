// SPDX-License-Identifier: MIT
//
// UDP for FIRASim and its clients, to multicast groups or to lists of addresses.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::firasim {

// An IPv4 address and a port, both in the host's byte order.
struct Endpoint {
  std::uint32_t address = 0;
  std::uint16_t port = 0;

  bool operator==(const Endpoint&) const = default;
  bool is_group() const { return address >> 28 == 0xe; }  // 224.0.0.0 to 239.255.255.255
};
std::string to_text(const Endpoint& endpoint);

// Parse "ADDR:PORT", and a list of such texts, separated by commas. `option` names the text in an
// error.
Result<Endpoint> parse_endpoint(const std::string& text, const std::string& option);
Result<std::vector<Endpoint>> parse_endpoints(const std::string& text, const std::string& option);

// True for an address of this host. A datagram with such a sender is from this host, because Linux
// drops all others with such a sender.
bool is_of_this_host(const Endpoint& endpoint);

// The interface with which datagrams to a group do not leave this host.
inline constexpr const char* this_host = "lo";

// Sends datagrams to a list of addresses.
//
// A sender joins each group on its own interface. If any socket of a host has joined a group on the
// interface of arrival, Linux gives a datagram to all sockets of the host that listen to the group.
// So each of these sockets gets the datagram once, whichever interface it has joined. A client that
// got two copies would answer twice, and the second answer would look like an answer to the next
// vision.
class Sender {
 public:
  static Result<Sender> open(std::vector<Endpoint> to, const std::string& interface);
  // Sends the datagram once to each address. If the system does not accept the datagram, it is
  // lost, as on a network.
  void send(const std::string& bytes) const;

 private:
  std::vector<Endpoint> to_;
  system::Descriptor socket_;
};

// Receives datagrams at one address and never waits.
class Receiver {
 public:
  // Opens a receiver at an address. As in FIRASim, address 0 is any address of the host and the
  // group of all hosts, 224.0.0.1. A group is joined on the interface and on lo.
  static Result<Receiver> open(const Endpoint& at, const std::string& interface,
                               const std::string& option);
  // Opens a second receiver at this address for the datagrams of `peer` alone. The second receiver
  // has a separate buffer, so other senders cannot crowd out these datagrams. The first receiver
  // then gets no datagrams of `peer`, unless the address is a group. Error: Errc::unavailable.
  Result<Receiver> only_from(const Endpoint& peer) const;

  struct Datagram {
    Endpoint from;
    std::string bytes;
  };
  // Returns false if no datagram has arrived. A datagram that is longer than max_size arrives
  // empty.
  bool receive(Datagram& datagram) const;
  int descriptor() const { return socket_.get(); }

  static constexpr std::size_t max_size = 4096;

 private:
  system::Descriptor socket_;
};

}  // namespace mirocup::firasim
