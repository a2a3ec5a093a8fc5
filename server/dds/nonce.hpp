// SPDX-License-Identifier: MIT
//
// Random numbers that identify processes and legs on the network.
#pragma once

#include <cstdint>

namespace mirocup::dds {

// Returns a number from the system's random generator; never 0.
std::uint64_t random_nonce();

}  // namespace mirocup::dds
