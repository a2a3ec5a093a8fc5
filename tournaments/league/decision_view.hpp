// SPDX-License-Identifier: MIT
//
// The decisions of persons in words, as pages, exports and commands show them.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

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
