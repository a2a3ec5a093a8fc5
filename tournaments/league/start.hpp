// SPDX-License-Identifier: MIT
//
// The start of a league: league.json is frozen, and the entries that play are booked.
#pragma once

#include "tournaments/league/league_store.hpp"

namespace mirocup::league {

// Starts the league if it has not started, and checks that the libraries have the digests in the
// journal. Errors: Errc::input if the league cannot be played; Errc::damaged if a library has
// changed, or if the journal has lost lines.
Result<void> start_league(system::Files& files, LeagueStore& store);

}  // namespace mirocup::league
