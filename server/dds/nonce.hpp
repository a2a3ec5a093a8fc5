// SPDX-License-Identifier: MIT
//
// Random numbers that identify processes and legs on the network.
#pragma once

#include <cstdint>

namespace mirocup::dds {

// Returns a number from the system's random generator; never 0.
std::uint64_t random_nonce();

// Returns a nonce for one more connection of this process: its upper 48 bits are the same for all
// of them, the others are random. So the server can tell a process that joins anew from another
// process.
std::uint64_t connection_nonce();

// Returns the part of a nonce that all connections of a process share.
inline std::uint64_t process_of_nonce(std::uint64_t nonce) {
  return nonce >> 16U;
}

}  // namespace mirocup::dds
