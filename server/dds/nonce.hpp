// SPDX-License-Identifier: MIT
//
// Numbers that tell processes and legs on the network apart.
#pragma once

#include <cstdint>

namespace mirocup::dds {

// Drawn by the system; never 0.
std::uint64_t random_nonce();

}  // namespace mirocup::dds
