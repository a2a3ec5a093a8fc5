// SPDX-License-Identifier: MIT
//
// A knockout: a bracket of ties. The winner of a tie enters the next round. The two best seeds can
// meet only in the final. If the number of teams is not a power of two, the best seeds have a bye
// in the first round.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <vector>

namespace mirocup::league {

struct KnockoutOptions {
  int legs = legs_per_fixture;  // of a tie
  bool third_place = true;      // true: the losers of the semi-finals also play
};

// Returns the ties for at least two seeds, the best first. `first` is the index of the first tie in
// the schedule; later ties name the ties whose winners they need by their index in the schedule.
// The numbers of a round run down the bracket. The tie for the third place is number 2 of the last
// round.
std::vector<Fixture> knockout(const std::vector<TeamSource>& seeds, const KnockoutOptions& options,
                              int first = 0);

// Returns the seeds (from 0) in the order in which they stand in a bracket of `size` places, which
// is a power of two.
std::vector<int> bracket_order(int size);

// The winner and the loser of a tie: no_team if both have left, unknown_team if it is not over.
struct TieOutcome {
  int winner = unknown_team;
  int loser = unknown_team;
};

}  // namespace mirocup::league
