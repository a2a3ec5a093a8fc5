// SPDX-License-Identifier: MIT
//
// A Swiss tournament: in each round teams meet that stand alike, nobody meets anybody twice. A
// fixture has two legs with ends swapped, so there is nothing to balance between colours.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <vector>

namespace mirocup::league {

// As many rounds as it takes to find one team without a loss.
int usual_swiss_rounds(int teams);

// The most that can be paired whatever the results are.
int max_swiss_rounds(int teams);

// How a team stands before a round.
struct SwissStanding {
  int team = 0;
  int points = 0;
};

// The fixtures of round `round` (from 1) of `rounds`. `standings` has all who still play, best
// first; `before` all earlier fixtures. With an odd number the lowest who has had none gets the bye:
// a fixture with nobody as away. Within a group of equal points the upper half meets the lower;
// points are as equal as can be from the top down. Empty if it cannot be done without a second
// meeting, which happens only beyond most_swiss_rounds() or when teams have left.
std::vector<Fixture> swiss_round(const std::vector<SwissStanding>& standings,
                                 const std::vector<Fixture>& before, int round, int rounds);

}  // namespace mirocup::league
