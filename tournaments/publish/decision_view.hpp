// SPDX-License-Identifier: MIT
//
// The decisions of persons in words, as pages and exports list them.
#pragma once

#include "tournaments/league/league_state.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

struct DecisionView {
  int number = 1;  // number of the decision, from 1, in the order of the journal
  // Kind of the decision's line: "void", "ruling", "withdraw", …
  std::string_view kind = {};
  std::string at = {};  // time of the decision, UTC; "" if its line has no time
  std::string by = {};  // the person; "" if the line names no person
  std::string what;     // "r1-f1 leg 2, a – b: 0:10"
  std::string why = {};
  int undone_by = 0;  // the number of the decision that ended this decision's effect; 0: none
  std::string undoing = {};  // undone_by in words: "overruled by 4"; "": none
};

// Returns all decisions, the latest last.
std::vector<DecisionView> decision_views(const LeagueState& state);

}  // namespace mirocup::league
