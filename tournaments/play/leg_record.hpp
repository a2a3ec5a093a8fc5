// SPDX-License-Identifier: MIT
//
// Converts the match record of a leg into the event that a league books.
#pragma once

#include "tournaments/league/event.hpp"
#include "tournaments/play/leg_command.hpp"

#include <optional>
#include <string>

namespace mirocup::league {

// Converts a match record of this leg to an event, with teams instead of colours and only the
// counts that the journal keeps. `record_path` is the path inside the league folder. Errc::damaged,
// with the JSON pointer, if the record lacks something that the journal needs, or if the match
// server called the leg void.
Result<LegPlayed> leg_played(const LeagueFile& file, const LegId& id, const Json& record,
                             const std::string& record_path);

// Returns the event of the leg if the folder has its record with the present teams, entries and
// seed; any program may have played the leg. Returns nothing if the record does not exist, has
// another seed or entry, or is of a void leg. A record that cannot be read may belong to a played
// leg, so it is an error: an error of Files::read_if_there(), or Errc::damaged.
Result<std::optional<LegPlayed>> find_played_leg(system::Files& files, const Folder& folder,
                                                 const LeagueState& state, const LegId& id);

// Returns the first key of a record that find_played_leg() has found which the leg cannot have:
// rules, conditions, stage or pitch that are not the league's, another start, or a result or
// decisions that contradict themselves. Returns "" if there is none.
Result<std::string> impossible_key(system::Files& files, const Folder& folder,
                                   const LeagueState& state, const LegId& id);

}  // namespace mirocup::league
