// SPDX-License-Identifier: MIT
//
// Advice to a team: a drill to practise for its most frequent losses, with the figure
// (docs/statistics.md, "Advice").
#pragma once

#include "record/statistics/totals.hpp"

#include <string>
#include <vector>

namespace mirocup::statistics {

struct Advice {
  std::string drill;  // of docs/drills.md
  std::string why;    // the figure, as part of a sentence: "3 of 7 goals against it were own goals"
  double weight = 0;  // about the number of goals that it cost; the greatest first
};

// Returns at most three pieces of advice for a team, named as in totals_of(), from its legs; none
// if no figure stands out.
std::vector<Advice> advice_for(const std::vector<LegReport>& legs, const TeamTotals& team);

}  // namespace mirocup::statistics
