// SPDX-License-Identifier: MIT
//
// The statistics of teams over all their legs.
#pragma once

#include "record/statistics/leg_report.hpp"

#include <string>
#include <vector>

namespace mirocup::statistics {

// The sums over the legs of one team. A value that both teams of a leg share counts in the sums of
// both teams.
struct TeamTotals {
  std::string name;
  int legs = 0;
  TeamStatistics own;
  TeamStatistics against;  // the sums of the opponents in these legs
  double play_s = 0.0;
  double dead_ball_s = 0.0;
  int duels = 0;

  void add(const LegStatistics& leg, Team team);
};

// Returns the name under which a team of a leg is counted: its own name, with its colour if both
// teams have the same name.
std::string counted_name(const LegReport& leg, Team team);

// Returns the sums of all teams, in the order in which they first appear, blue first.
std::vector<TeamTotals> totals_of(const std::vector<LegReport>& legs);

}  // namespace mirocup::statistics
