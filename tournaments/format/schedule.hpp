// SPDX-License-Identifier: MIT
//
// Who meets whom. Everything has an id that comes from the schedule, so a league that is played in
// any order, with any number of jobs, books the same results. Teams are indices into the league's
// list.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// Instead of a team.
inline constexpr int no_team = -1;       // a bye, or a place that stays empty
inline constexpr int unknown_team = -2;  // decided by a fixture that is not over

// Who takes a place in a fixture.
struct TeamSource {
  enum class Kind {
    team,    // `index` is a team, or nobody
    winner,  // of the fixture with that index in the schedule
    loser,
    place,  // number `place` in the table of the group `index`; both from 0
  };
  Kind kind = Kind::team;
  int index = no_team;
  int place = 0;
};

// Whether a fixture counts in the table of all, in that of a group, or decides who goes on.
enum class Part { table, group, knockout };

// Legs of the same two teams: the same seed, colours swapped from leg to leg.
struct Fixture {
  int round = 1;   // within its part, from 1
  int number = 1;  // within the round, from 1
  int home = 0;    // blue in the first leg; or nobody, or unknown
  int away = 0;
  int legs = 2;  // a tie of a knockout that is level after them has one more
  Part part = Part::table;
  int group = 0;             // from 1, in a group only
  TeamSource home_source{};  // in a knockout only
  TeamSource away_source{};

  // "r2-f1", "g3-r2-f1", "k2-f1".
  std::string id() const;
  bool has_both() const { return home >= 0 && away >= 0; }
  bool is_for_third_place() const { return home_source.kind == TeamSource::Kind::loser; }
};

inline constexpr int legs_per_fixture = 2;

// The legs of a tie that may be needed: its own, and the one that decides.
inline constexpr int max_legs = legs_per_fixture + 1;

// Every pair once, by the circle method: in each round every team plays at most once; with an odd
// number one has a bye. A team is home in half of its fixtures, or in one more or less.
std::vector<Fixture> round_robin(int teams);

// Every pair plays `legs` legs: fixtures of two, for an odd number one more of a single leg. Homes
// are swapped from one time round to the next.
std::vector<Fixture> round_robin(int teams, int legs);

// The seed of all legs of a fixture, from the league's seed and who plays, not from when.
std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture);

}  // namespace mirocup::league
