// SPDX-License-Identifier: MIT
//
// A Swiss tournament: in each round teams of similar points meet, and no two teams meet twice. A
// fixture has two legs with colours swapped, so the pairing ignores colours.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <cstdint>
#include <vector>

namespace mirocup::league {

// Returns the number of rounds after which at most one team has won all fixtures: log2(teams),
// rounded up, or max_swiss_rounds() if that is less.
int usual_swiss_rounds(int teams);

// Returns the number of rounds that can be paired, whatever the results are.
int max_swiss_rounds(int teams);

// The points of a team before a round.
struct SwissStanding {
  int team = 0;
  std::int64_t points = 0;
};

// Returns the fixtures of round `round` (from 1) of `rounds`. `standings` has all teams that still
// play, the best first; `before` has all earlier fixtures. Within a group of equal points the upper
// half meets the lower half; from the top down, opponents have points as equal as possible. With an
// odd number of teams one team gets a bye, a fixture with no_team as away: the best of the teams
// with the fewest points, in the first round the last team, of those that have had no bye and whose
// bye lets all other teams be paired. Teams that have had a bye come last in their group. Returns
// no fixtures if every pairing repeats a meeting, which is possible only beyond max_swiss_rounds()
// or after teams have left.
std::vector<Fixture> swiss_round(std::vector<SwissStanding> standings,
                                 const std::vector<Fixture>& before, int round, int rounds);

}  // namespace mirocup::league
