// SPDX-License-Identifier: MIT
//
// The list of the decisions of persons, LeagueState::decisions, and the later decisions that undo
// earlier ones.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>
#include <string_view>
#include <vector>

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

// Returns what a decision does: "r1-f1 leg 2, a – b: 0:10"; "" for another event.
std::string decision_in_words(const LeagueState& state, const Event& event);

struct DecisionView {
  int number = 1;  // number of the decision, from 1, in the order of the journal
  // Kind of the decision's line: "void", "ruling", "withdraw", …
  std::string_view kind = {};
  Signature signature = {};
  std::string what;   // decision_in_words(), and the value before it: "… (was 2:1)"
  int undone_by = 0;  // the number of the decision that ended this decision's effect; 0: none
  std::string undoing = {};  // undone_by in words: "overruled by 4"; "": none
};

// Returns all decisions, the latest last.
std::vector<DecisionView> decision_views(const LeagueState& state);

}  // namespace mirocup::league
