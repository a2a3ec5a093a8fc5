// SPDX-License-Identifier: MIT
//
// A descriptor that one process hands to another over a socket of packets (SOCK_SEQPACKET).
#pragma once

#include "system/descriptor.hpp"

#include <cstddef>

namespace mirocup::plugins {

// Sends a descriptor. Returns false on failure; errno says why. The sender still owns its
// descriptor.
bool send_descriptor(int socket, int descriptor);

// Reads the next packet: up to `size` bytes into `text`, and the descriptor into `descriptor` if
// the packet has one. Returns the number of bytes; 0 at the end of the packets; a negative number
// on failure.
ssize_t receive_packet(int socket, char* text, std::size_t size, system::Descriptor& descriptor);

}  // namespace mirocup::plugins
