// SPDX-License-Identifier: MIT
//
// Cyclone DDS 0.10 binds its sockets to all addresses of the host. Here they are made to take only
// what was sent to one interface, as if they were bound to it.
#pragma once

#include <string>
#include <vector>

namespace mirocup::dds {

// The descriptors of this process that are open, in order.
std::vector<int> open_descriptors();

// Every IPv4 datagram socket that is open now and was not `before` drops what was sent to other
// addresses than those of `interface` (a name or an IPv4 address). Without such an address nothing
// changes.
void bind_to_interface(const std::vector<int>& before, const std::string& interface);

}  // namespace mirocup::dds
