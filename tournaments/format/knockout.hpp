// SPDX-License-Identifier: MIT
//
// A knockout: a bracket of ties, in which the winner of a tie goes on. The two best seeds can meet
// only in the final. If the number of teams is not a power of two, the best seeds have a bye in the
// first round.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <vector>

namespace mirocup::league {

struct KnockoutOptions {
  int legs = legs_per_fixture;  // of a tie
  bool third_place = true;      // true: the losers of the semi-finals play for the third place
};

// Returns the ties for these seeds, best first. Precondition: at least two seeds. `first` is the
// index of the first tie in the schedule: later ties refer to earlier ones by their index there.
// The ties of a round are numbered from the top of the bracket down; the tie for the third place is
// number 2 of the last round.
std::vector<Fixture> knockout(const std::vector<TeamSource>& seeds, const KnockoutOptions& options,
                              int first = 0);

// Returns the seeds (from 0) in their order down a bracket of `size` places, which is a power of
// two.
std::vector<int> bracket_order(int size);

// The winner and the loser of a tie: no_team if both teams forfeited, unknown_team until it is
// over.
struct TieOutcome {
  int winner = unknown_team;
  int loser = unknown_team;
};

}  // namespace mirocup::league
