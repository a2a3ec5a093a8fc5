// SPDX-License-Identifier: MIT
//
// A leg written down so that it can be played again without the teams: what it depended on, what
// was commanded in every tick, and a hash of the state after each.
#pragma once

#include "core/match/match.hpp"

#include <vector>

namespace mirocup::replay {

struct Recording {
  match::Setup setup;
  std::vector<match::TickLog> ticks;
  std::vector<match::LoggedDecision> decisions;
  match::Result result;
  std::uint64_t state_hash = 0;
};

// Of a match that is over.
Recording record(const match::Match& match);

}  // namespace mirocup::replay
