// SPDX-License-Identifier: MIT
//
// What a host shows of a league round by round, whatever has been played already.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

#include <string>

namespace mirocup::league {

// The league as if nothing had been played after a round: "r3", the third of a table or of all
// groups; "k1", the first of a knockout, after all groups. `whole` is where it really stands. Who
// has left or is paused is so in every round.
Result<LeagueState> state_through(const LeagueState& whole, const Journal& journal,
                                  const std::string& round);

// Copies the records of what was played in `state`, with their replays, into another folder.
Result<void> copy_records(system::Files& files, const Folder& from, const LeagueState& state,
                          const Folder& to);

}  // namespace mirocup::league
