// SPDX-License-Identifier: MIT
//
// Advice to a team: the drills that it should practise, each with the figure of the team's
// statistics that is the reason (docs/statistics.md, "Advice").
#pragma once

#include "record/statistics/leg_report.hpp"

#include <string>
#include <vector>

namespace mirocup::statistics {

struct Advice {
  std::string drill;  // name of a drill of docs/drills.md
  std::string why;    // the figure, as part of a sentence: "3 of 7 goals against it were own goals"
  double weight = 0;  // about the number of goals that the weakness cost
  // The first moments that show it, in s since the leg began, for the pages of `mirocup replay`:
  // "leg.json 12.4 s, 31.0 s"; "" if there are none to show.
  std::string moments = {};
};

// Returns at most three pieces of advice, the greatest weight first; none if no figure stands out.
// `team` must be one of totals_of(legs).
std::vector<Advice> advice_for(const std::vector<LegReport>& legs, const TeamTotals& team);

}  // namespace mirocup::statistics
