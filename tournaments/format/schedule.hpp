// SPDX-License-Identifier: MIT
//
// Who meets whom: pure functions of the number of teams. Everything has an id that comes from the
// schedule, so a league that is played in any order, with any number of jobs, books the same
// results.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// Two legs of the same two teams: the same seed, colours swapped. Teams are indices into the
// league's list.
struct Fixture {
  int round = 1;   // from 1
  int number = 1;  // within the round, from 1
  int home = 0;    // blue in the first leg
  int away = 0;

  std::string id() const { return "r" + std::to_string(round) + "-f" + std::to_string(number); }
};

inline constexpr int legs_per_fixture = 2;

// Every pair once, by the circle method: in each round every team plays at most once; with an odd
// number one has a bye. A team is home in half of its fixtures, or in one more or less.
std::vector<Fixture> round_robin(int teams);

// The seed of both legs of a fixture, from the league's seed and who plays, not from when.
std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture);

}  // namespace mirocup::league
