// SPDX-License-Identifier: MIT
//
// The list of the decisions of persons, LeagueState::decisions, and the later decisions that undo
// earlier ones.
#pragma once

#include "tournaments/league/league_state.hpp"

namespace mirocup::league {

// If the event is a decision of a person, appends it to the list and marks the decisions that it
// undoes. `state` is the state before the event. Precondition: validate() accepts the event. `line`
// is the number of the event's line.
void note_decision(LeagueState& state, const Event& event, int line);

// Like note_decision(), for a decision that a later line undoes: the decision is listed and changes
// nothing.
void note_undone_decision(LeagueState& state, const Event& event, int line);

// True if the event is a decision of a person.
bool is_of_person(const Event& event);

// Returns the score of the leg that a decision is about, as it is before it: "was 2:1"; "" if the
// decision is not about a leg.
std::string before_in_words(const LeagueState& state, const Event& event);

}  // namespace mirocup::league
