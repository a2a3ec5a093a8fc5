// SPDX-License-Identifier: MIT
//
// Snapshots of a league: its state after a given round, even if later rounds have been played.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

// Returns the league as if no leg had been played after a round. "r3" is the third round of a table
// or of all groups; "k1" is the first round of a knockout, after all groups. `whole` is the present
// state. Withdrawals and pauses apply to every round.
Result<LeagueState> state_through(const LeagueState& whole, const Journal& journal,
                                  const std::string& round);

// Copies the records of the legs that are played in `state`, with their replays, to another folder.
Result<void> copy_records(system::Files& files, const Folder& from, const LeagueState& state,
                          const Folder& to);

}  // namespace mirocup::league
