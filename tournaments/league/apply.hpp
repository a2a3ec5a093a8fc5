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

// Returns a league that has not started, with the part of its schedule that does not depend on
// results.
LeagueState new_league(LeagueFile file);

// The same without fixtures, for questions about its teams: the 20 000 fixtures of 200 teams take
// 10 ms. plan() adds the fixtures, unless the league has some; the start of the league also adds
// them.
LeagueState unplanned_league(LeagueFile file);
void plan(LeagueState& state);

// Checks that the state allows the event. Otherwise the error (Errc::input) is a sentence for the
// person who wanted it. Journal checks the numbers and hashes of lines.
Result<void> validate(const LeagueState& state, const Event& event);

// Applies an event. Precondition: validate() accepts it in this state. `line` is the number of its
// line, by which Undone names it. Undone itself only enters the list of decisions: when a state is
// made from the journal, the decision that it takes back is skipped.
void apply(LeagueState& state, const Event& event, int line = 0);

// Decodes, validates and applies one line of the journal at `journal_path`. The error
// (Errc::damaged) names that path, the line and the reason; then the state is unchanged.
Result<void> apply_line(LeagueState& state, const Json& line, const std::string& journal_path);

// Returns the state after all lines of a journal except undone decisions. If the journal has no
// line, the state has no fixtures. Errors are those of apply_line().
Result<LeagueState> state_from_journal(LeagueFile file, const Journal& journal);

// The same for the first `count` lines alone. The state also skips the decision of the line
// `undoing` (0: none), which a caller is about to undo.
Result<LeagueState> state_from_lines(LeagueFile file, const Journal& journal, std::size_t count,
                                     int undoing = 0);

// Returns the numbers of those of the first `count` lines that a later one of them undoes.
std::set<int> undone_lines(const Journal& journal, std::size_t count);

}  // namespace mirocup::league
