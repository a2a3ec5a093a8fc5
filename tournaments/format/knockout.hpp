// SPDX-License-Identifier: MIT
//
// A knockout: a bracket of ties. The winner of each tie plays in the next round. The two best seeds
// can meet only in the final. If the number of teams is not a power of two, the best seeds have a
// bye in the first round.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <vector>

namespace mirocup::league {

struct KnockoutOptions {
  int legs = legs_per_fixture;  // number of legs of a tie
  bool third_place = true;      // true: the losers of the semi-finals also play
};

// Returns the seeds (from 0) in the order of their places in a bracket, from the top down. `size`,
// the number of places, is a power of two.
std::vector<int> bracket_order(int size);

// Returns the ties of a knockout for `seeds`, at least two teams, the best first. `first` is the
// index of the first tie in the schedule. A tie of a later round names, by its index in the
// schedule, each tie whose winner plays in it. The ties of a round are numbered from the top of the
// bracket down. The tie for the third place is number 2 of the last round.
std::vector<Fixture> knockout(const std::vector<TeamSource>& seeds, const KnockoutOptions& options,
                              int first = 0);

// The winner and the loser of a tie: no_team if both teams have left, unknown_team if the tie is
// not over.
struct TieOutcome {
  int winner = unknown_team;
  int loser = unknown_team;
};

}  // namespace mirocup::league
