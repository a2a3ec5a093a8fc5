// SPDX-License-Identifier: MIT
//
// Converts the match record of a leg into the event that a league books.
#pragma once

#include "tournaments/league/event.hpp"
#include "tournaments/play/leg_command.hpp"

#include <optional>
#include <string>

namespace mirocup::league {

// The event of a match record of this leg: colours become teams, and it has only the counts that
// the journal keeps. `record_path` is the path inside the league folder. Error: Errc::damaged, with
// the JSON pointer, if the record lacks something that the journal needs, or if the match server
// called the leg void.
Result<LegPlayed> leg_played(const LeagueFile& file, const LegId& id, const Json& record,
                             const std::string& record_path);

// Returns the event of the leg if its record is in the folder and has these teams, entries and this
// seed, whichever program has played it. Returns nothing if there is no record, or if it is of
// another seed or entry, or of a void leg. A record that cannot be read may belong to a played leg,
// so it is an error: as in Files::read_if_there(), or Errc::damaged.
Result<std::optional<LegPlayed>> find_played_leg(system::Files& files, const Folder& folder,
                                                 const LeagueState& state, const LegId& id);

}  // namespace mirocup::league
