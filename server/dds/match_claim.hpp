// SPDX-License-Identifier: MIT
//
// A match ID belongs to one match server of a host at a time. Two with the same ID would share a
// partition, and tear the teams apart between their legs.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <string>

namespace mirocup::dds {

// Claims the ID on this host, for as long as the descriptor is open. The system takes the claim
// back when the process ends, however it does. Errc::unavailable: another process has it.
Result<system::Descriptor> claim_match(const std::string& match_id, int domain);

}  // namespace mirocup::dds
