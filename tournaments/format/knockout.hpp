// SPDX-License-Identifier: MIT
//
// A knockout: a bracket of ties. Who wins a tie goes on; the two best seeds can only meet in the
// final; with a number of teams that is no power of two the best seeds have a bye in the first
// round.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <vector>

namespace mirocup::league {

struct KnockoutOptions {
  int legs = legs_per_fixture;  // of a tie
  bool third_place = true;      // do the losers of the semi-finals play?
};

// The ties for these seeds, best first, at least two. `first` is the index that the first tie will
// have in the schedule: later ties name those that they follow from by their index there. The
// numbers of a round run down the bracket; the tie for the third place is number 2 of the last.
std::vector<Fixture> knockout(const std::vector<TeamSource>& seeds, const KnockoutOptions& options,
                              int first = 0);

// The seeds (from 0) in the order in which they stand in a bracket of `size` places, a power of two.
std::vector<int> bracket_order(int size);

// Who won and who lost a tie; nobody if both forfeited, unknown if it is not over.
struct TieOutcome {
  int winner = unknown_team;
  int loser = unknown_team;
};

}  // namespace mirocup::league
