// SPDX-License-Identifier: MIT
//
// A match ID belongs to one match server of a host at a time. Two servers with the same ID would
// share a partition, and each team would get states of both legs.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <string>

namespace mirocup::dds {

// Claims the match ID on this host for as long as the descriptor is open. The system releases the
// claim when the process ends, even if it is killed. Errc::unavailable: another process has the
// claim.
Result<system::Descriptor> claim_match(const std::string& match_id, int domain);

}  // namespace mirocup::dds
