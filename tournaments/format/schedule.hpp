// SPDX-License-Identifier: MIT
//
// The schedule: which teams meet, in which rounds. Ids and seeds of fixtures follow from the
// schedule alone, so a league has the same results in whatever order and with however many jobs it
// is played. Teams are indices into the league's list of teams.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// Values that stand for a team.
inline constexpr int no_team = -1;       // a bye, or a place that stays empty
inline constexpr int unknown_team = -2;  // decided by a fixture that is not over

// Where a team of a fixture comes from.
struct TeamSource {
  enum class Kind {
    team,    // `index` is the team, or no_team
    winner,  // of the fixture with the index `index` in the schedule
    loser,   // of that fixture
    place,   // number `place` in the table of the group `index`, both from 0
  };
  Kind kind = Kind::team;
  int index = no_team;
  int place = 0;
};

// The part of a league to which a fixture belongs: the table of all teams, the table of a group, or
// the knockout.
enum class Part { table, group, knockout };

// The legs of two teams: they have the same seed, and the teams swap colours from leg to leg.
struct Fixture {
  int round = 1;   // within its part, from 1
  int number = 1;  // within the round, from 1
  int home = 0;    // blue in the first leg; may be no_team or unknown_team
  int away = 0;
  int legs = 2;  // a tie of the knockout that is then level has one more
  Part part = Part::table;
  int group = 0;             // from 1; Part::group only
  TeamSource home_source{};  // Part::knockout only
  TeamSource away_source{};

  // Returns the id, unique in the league: "r2-f1", "g3-r2-f1", "k2-f1".
  std::string id() const;

  // True if both teams are known.
  bool has_both() const { return home >= 0 && away >= 0; }
  bool is_for_third_place() const { return home_source.kind == TeamSource::Kind::loser; }
};

inline constexpr int legs_per_fixture = 2;

// The most legs that a fixture can need: its own, and one that decides a level tie.
inline constexpr int max_legs = legs_per_fixture + 1;

// Returns a fixture for every pair, by the circle method. In each round every team plays at most
// once; with an odd number of teams one has a bye. The home and away fixtures of a team differ in
// number by at most one.
std::vector<Fixture> round_robin(int teams);

// Returns fixtures such that every pair plays `legs` legs: fixtures of two legs, and for an odd
// number a last fixture of one leg. Home and away are swapped each time that a pair meets again.
std::vector<Fixture> round_robin(int teams, int legs);

// Returns the fixtures of a night (from 1) among some teams, all in one round of that number: every
// pair, or `opponents` fixtures for each team (0: all), with an odd number of teams, some teams
// have one less. Over the nights every pair meets equally often.
std::vector<Fixture> night_fixtures(int night, const std::vector<int>& teams, int opponents);

// Returns the seed of all legs of a fixture, of 53 bits, which depends only on the seed of the
// league, the round and the teams.
std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture);

}  // namespace mirocup::league
