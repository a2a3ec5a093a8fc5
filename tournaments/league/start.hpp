// SPDX-License-Identifier: MIT
//
// The start of a league: what was decided is frozen, the entries that play are booked.
#pragma once

#include "tournaments/league/league_store.hpp"

namespace mirocup::league {

// Starts the league if it has not started, and makes sure that the libraries that play are those
// that the journal names. Errors: Errc::input if it cannot be played as it is; Errc::damaged if a
// library has changed.
Result<void> start_league(system::Files& files, LeagueStore& store);

}  // namespace mirocup::league
