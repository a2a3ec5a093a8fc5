// SPDX-License-Identifier: MIT
//
// The part of a league that the public sees: the rounds that its staff has released.
#pragma once

#include "tournaments/league/league_store.hpp"

namespace mirocup::league {

// True if the public sees every round.
bool is_all_released(const LeagueState& state);

// Returns the state that the public sees. Errors are those of state_through().
Result<LeagueState> released_state(const LeagueState& whole, const Journal& journal);

}  // namespace mirocup::league
