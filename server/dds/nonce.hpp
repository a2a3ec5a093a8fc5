// SPDX-License-Identifier: MIT
//
// Random numbers that identify processes and legs on the network.
#pragma once

#include <cstdint>

namespace mirocup::dds {

// Returns a random number from the system's generator; never 0.
std::uint64_t random_nonce();

// Returns a nonce for one more connection of this process. The upper 48 bits are equal for all
// connections of the process, the lower 16 bits are random. So the server can tell a process that
// joins anew from another process.
std::uint64_t connection_nonce();

// Returns the part of a nonce that all connections of a process share.
inline std::uint64_t process_of_nonce(std::uint64_t nonce) {
  return nonce >> 16U;
}

}  // namespace mirocup::dds
