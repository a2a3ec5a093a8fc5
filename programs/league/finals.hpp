// SPDX-License-Identifier: MIT
//
// Leagues that are made from the table of another league: finals, and the closing round of a term.
#pragma once

#include "tournaments/league/league_store.hpp"

#include <string>

namespace mirocup::league {

// Returns the knockout of the first teams of the season's table, the first as the best seed. It
// plays as the season does, except for its format. Errors: Errc::input if fewer teams have played
// and have not withdrawn.
Result<LeagueFile> finals(system::Files& files, const LeagueStore& season, const std::string& title,
                          int top);

// Returns the closing round of a season: a round robin with `legs` legs of each pair. Every team
// that has not withdrawn and has an accepted entry plays with its last one, or with the entry that
// it has pinned. Errors: Errc::input if there are fewer than two such teams.
Result<LeagueFile> closing_round(system::Files& files, const LeagueStore& season, FormatKind kind,
                                 int legs);

// Creates the folder of such a league, with the members and the display names of its teams or, if
// `knows_everybody`, of all teams of the season, so that grades have a row for each.
Result<void> init_from(system::Files& files, const LeagueStore& season, const Folder& folder,
                       const LeagueFile& file, bool knows_everybody);

}  // namespace mirocup::league
