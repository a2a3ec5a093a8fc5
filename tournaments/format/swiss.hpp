// SPDX-License-Identifier: MIT
//
// A Swiss tournament: in each round teams of similar points meet, and no two teams meet twice. A
// fixture has two legs with ends swapped, so colours need no balancing between rounds.
#pragma once

#include "tournaments/format/schedule.hpp"

#include <vector>

namespace mirocup::league {

// Returns the number of rounds after which at most one team is without a loss, log2(teams) rounded
// up, but at most max_swiss_rounds().
int usual_swiss_rounds(int teams);

// Returns the largest number of rounds that can be paired whatever the results are.
int max_swiss_rounds(int teams);

// A team with its points before a round.
struct SwissStanding {
  int team = 0;
  int points = 0;
};

// Returns the fixtures of round `round` (from 1) of `rounds`. `standings` lists the teams that
// still play, best first; `before` lists all earlier fixtures. If the number of teams is odd, the
// lowest team without an earlier bye gets one: a fixture whose away team is no_team. From the top
// down, each team meets an opponent of points as equal as possible; among teams of equal points the
// upper half meets the lower half. The result is empty if some pair would have to meet twice, which
// happens only beyond max_swiss_rounds() or after teams have left.
std::vector<Fixture> swiss_round(const std::vector<SwissStanding>& standings,
                                 const std::vector<Fixture>& before, int round, int rounds);

}  // namespace mirocup::league
