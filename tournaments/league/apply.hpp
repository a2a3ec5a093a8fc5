// SPDX-License-Identifier: MIT
//
// The rules of a league as a machine of events: whether an event may follow, and what it changes. A
// league's state is its league.json plus all events of its journal, applied in order.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/event.hpp"
#include "tournaments/league/league_state.hpp"

#include <string>

namespace mirocup::league {

// A league that has not started, with the part of its schedule that is known already.
LeagueState new_league(LeagueFile file);

// Checks that the event may follow in this state. Otherwise returns a sentence for the person who
// wanted it (Errc::input). The numbers and hashes of lines are checked by Journal.
Result<void> validate(const LeagueState& state, const Event& event);

// Applies an event. Precondition: validate() accepts it in this state.
void apply(LeagueState& state, const Event& event);

// Decodes, validates and applies one line of the journal at `journal_path`. The error
// (Errc::damaged) names that path, the line and the reason; then the state is as before.
Result<void> apply_line(LeagueState& state, const Json& line, const std::string& journal_path);

// The state after all lines of a journal. Errors as of apply_line().
Result<LeagueState> state_from_journal(LeagueFile file, const Journal& journal);

}  // namespace mirocup::league
