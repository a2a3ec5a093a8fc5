// SPDX-License-Identifier: MIT
//
// Verification of a recording: simulator and referee play it again from the commands alone.
#pragma once

#include "core/replay/playback.hpp"

#include <cstdint>
#include <optional>

namespace mirocup::replay {

// Returns the first difference, or nothing if every hash, every decision and the outcome are
// reproduced. If `found` is not null, it is set to the last state hash of this simulation.
std::optional<Divergence> verify(const Recording& recording, std::uint64_t* found = nullptr);

// The part of verify() after the last tick, for callers that have played the recording again
// themselves: returns the first difference in the decisions, the outcome and the last state hash.
// Precondition: `again` is over.
std::optional<Divergence> compare_results(const Recording& recording, const match::Leg& again);

}  // namespace mirocup::replay
