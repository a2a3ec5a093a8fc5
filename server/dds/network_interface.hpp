// SPDX-License-Identifier: MIT
//
// Cyclone DDS 0.10 binds its sockets to all addresses of the host. A socket filter restricts the
// sockets to packets for the addresses of one interface, as if they were bound to that interface.
#pragma once

#include <string>
#include <vector>

namespace mirocup::dds {

// Returns the open file descriptors of this process in ascending order.
std::vector<int> open_descriptors();

// Restricts every IPv4 datagram socket that is open now and is not in `before` to `interface` (a
// name or an IPv4 address): the socket drops packets that were sent to other addresses. Changes
// nothing if the interface has no IPv4 address.
void bind_to_interface(const std::vector<int>& before, const std::string& interface);

// Returns the address of this host from which packets to `address` leave: that of `interface` or,
// if it is empty, the one that the routing table names. "" if there is no such interface or route.
std::string own_address_towards(const std::string& address, const std::string& interface = "");

// True if the interface (a name or an IPv4 address) is up and has a carrier and an IPv4 address.
bool interface_is_up(const std::string& interface);

}  // namespace mirocup::dds
