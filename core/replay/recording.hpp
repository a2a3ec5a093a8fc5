// SPDX-License-Identifier: MIT
//
// The recording of a leg, from which it can be played again without the teams: its setup, the
// commands of every tick, the placement requests at restarts, and a hash of the state after each
// tick.
#pragma once

#include "core/replay/state_trace.hpp"

#include <optional>
#include <vector>

namespace mirocup::replay {

struct Recording {
  match::Setup setup;
  std::vector<match::TickLog> ticks;
  std::vector<match::LoggedPlacementRequest> placement_requests;  // in the order of the ticks
  std::vector<match::LoggedDecision> decisions;
  match::Outcome outcome;
  std::uint64_t state_hash = 0;
  StateTrace trace;  // may be empty
};

// Returns the recording of a leg that is over, with the trace of its bodies if one was kept.
Recording record(const match::Leg& leg, StateTrace trace = {});

// Returns the placement that the team asked for in that tick, if it did.
std::optional<match::PlacementRequest> requested_in(const Recording& recording, std::uint32_t tick,
                                                    Team team);

}  // namespace mirocup::replay
