// SPDX-License-Identifier: MIT
//
// The rules of a league as a state machine: validate() says whether an event is allowed in a state,
// and apply() changes the state by the event. The state of a league is its league.json with all
// events of its journal applied in order.
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

// Like new_league(), but without fixtures, for callers that need only the teams: making the 20 000
// fixtures of 200 teams takes 10 ms. plan(), or the start of the league, adds the fixtures later.
LeagueState unplanned_league(LeagueFile file);
void plan(LeagueState& state);

// Checks that the state allows the event. Otherwise the error (Errc::input) is a sentence for the
// person who wanted the event. Journal checks the numbers and hashes of lines.
Result<void> validate(const LeagueState& state, const Event& event);

// Applies an event. Precondition: validate() accepts it in this state. `line` is the number of the
// event's line, by which an event Undone names it. An event Undone only enters the list of
// decisions, because a state is made from the journal without the undone decision.
void apply(LeagueState& state, const Event& event, int line = 0);

// Decodes, validates and applies one line of the journal at `journal_path`. The error
// (Errc::damaged) names that path, the line and the reason; then the state is unchanged.
Result<void> apply_line(LeagueState& state, const Json& line, const std::string& journal_path);

// Returns the state after all lines of a journal except undone decisions. If the journal has no
// line, the state has no fixtures. Errors are those of apply_line().
Result<LeagueState> state_from_journal(LeagueFile file, const Journal& journal);

// Returns the state after the first `count` lines alone, except undone decisions and the
// decision of the line `undoing` (0: none), which the caller is about to undo.
Result<LeagueState> state_from_lines(LeagueFile file, const Journal& journal, std::size_t count,
                                     int undoing = 0);

// Among the first `count` lines, returns the numbers of the lines that a later line undoes.
std::set<int> undone_lines(const Journal& journal, std::size_t count);

}  // namespace mirocup::league
