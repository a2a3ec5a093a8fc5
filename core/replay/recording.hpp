// SPDX-License-Identifier: MIT
//
// A leg written down so that it can be played again without the teams: what it depended on, what
// was commanded in every tick and asked for at restarts, and a hash of the state after each.
#pragma once

#include "core/replay/state_trace.hpp"

#include <optional>
#include <vector>

namespace mirocup::replay {

struct Recording {
  match::Setup setup;
  std::vector<match::TickLog> ticks;
  std::vector<match::LoggedPlacementRequest>
      placement_requests;  // at restarts, in the order of the ticks
  std::vector<match::LoggedDecision> decisions;
  match::Outcome outcome;
  std::uint64_t state_hash = 0;
  StateTrace trace;  // may be empty
};

// Of a match that is over, and what was traced of it.
Recording record(const match::Leg& leg, StateTrace trace = {});

// What the team asked for in that tick, if it did.
std::optional<match::PlacementRequest> requested_in(const Recording& recording, std::uint32_t tick,
                                                    Team team);

}  // namespace mirocup::replay
