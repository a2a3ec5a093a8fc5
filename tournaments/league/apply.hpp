// SPDX-License-Identifier: MIT
//
// The rules of a league as a state machine: validate() says whether an event is allowed in a state,
// and apply() changes the state by it. The state of a league is its league.json with all events of
// its journal applied in order.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/event.hpp"
#include "tournaments/league/league_state.hpp"

#include <set>
#include <string>

namespace mirocup::league {

// Returns a league that has not started, with the part of its schedule that is known already.
LeagueState new_league(LeagueFile file);

// The same without a fixture, which is enough to ask about its teams: the 20 000 fixtures of 200
// teams take 10 ms. plan() adds them; the start of the league does that, too. A league that has
// fixtures keeps them.
LeagueState unplanned_league(LeagueFile file);
void plan(LeagueState& state);

// Checks that the state allows the event. Otherwise the error (Errc::input) is a sentence for the
// person who asked for it. Journal checks the numbers and hashes of lines.
Result<void> validate(const LeagueState& state, const Event& event);

// Applies an event. Precondition: validate() accepts it in this state. `line` is the number of its
// line, by which Undone names it. Undone itself only enters the list of decisions: what it takes
// back is left out when the state is made from the journal.
void apply(LeagueState& state, const Event& event, int line = 0);

// Decodes, validates and applies one line of the journal at `journal_path`. The error
// (Errc::damaged) names that path, the line and the reason; then the state is unchanged.
Result<void> apply_line(LeagueState& state, const Json& line, const std::string& journal_path);

// Returns the state after all lines of a journal, without what was undone. Without a line there are
// no fixtures. Errors are those of apply_line().
Result<LeagueState> state_from_journal(LeagueFile file, const Journal& journal);

// The same for its first `count` lines, as if that was all that had happened until then. The state
// also leaves out the decision of the line `undoing` (0: none), as it is before Undone is written.
Result<LeagueState> state_from_lines(LeagueFile file, const Journal& journal, std::size_t count,
                                     int undoing = 0);

// Returns the numbers of the first `count` lines that later ones of these undo.
std::set<int> undone_lines(const Journal& journal, std::size_t count);

}  // namespace mirocup::league
