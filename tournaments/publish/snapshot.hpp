// SPDX-License-Identifier: MIT
//
// A league as it stood after a round, for a host who shows the results round by round.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

// Returns the state as if nothing had been played after a round. "r3" is the third round of a table
// or of all groups; "k1" is the first round of a knockout, which follows all groups. `whole` is the
// present state. Withdrawals and pauses show in every round. Errors: Errc::input if there is no
// such round, or if an event of the rounds shown depends on a later one.
Result<LeagueState> state_through(const LeagueState& whole, const Journal& journal,
                                  const std::string& round);

// Copies the records of the legs that `state` holds, with their replays, to another folder.
Result<void> copy_records(system::Files& files, const Folder& from, const LeagueState& state,
                          const Folder& to);

}  // namespace mirocup::league
