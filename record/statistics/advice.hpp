// SPDX-License-Identifier: MIT
//
// What a team could practise: the drill that belongs to what it lost, with the figure
// (docs/statistics.md, "Advice").
#pragma once

#include "record/statistics/totals.hpp"

#include <string>
#include <vector>

namespace mirocup::statistics {

struct Advice {
  std::string drill;  // of docs/drills.md
  std::string why;    // the figure, as part of a sentence: "3 of 7 goals against it were own goals"
  double weight = 0;  // goals that it cost, about; the greatest first
};

// Returns the advice for a team, named as in totals_of(), from its legs: at most three, and none if
// nothing stands out.
std::vector<Advice> advice_for(const std::vector<LegReport>& legs, const TeamTotals& team);

}  // namespace mirocup::statistics
