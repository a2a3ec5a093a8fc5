// SPDX-License-Identifier: MIT
//
// Fixtures, and the round robin. Every fixture has an id that depends on the schedule alone, so
// that a league books the same results in whatever order and with however many jobs it is played.
// Teams are indices into the league's list of teams.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::league {

// Values that stand for the index of a team.
inline constexpr int no_team = -1;       // a bye, or a place that stays empty
inline constexpr int unknown_team = -2;  // decided by a fixture that is not over

// The rule by which a side of a fixture gets its team.
struct TeamSource {
  enum class Kind {
    team,    // `index` is a team, or no_team
    winner,  // winner of the fixture with that index in the schedule
    loser,   // its loser
    place,   // team at `place` in the table of the group `index`; both from 0
  };
  Kind kind = Kind::team;
  int index = no_team;
  int place = 0;
};

// The part of a league that a fixture belongs to: the table of all teams, the table of a group, or
// the knockout.
enum class Part { table, group, knockout };

// Two teams that meet, with all their legs. The legs have the same seed, with colours swapped from
// leg to leg.
struct Fixture {
  int round = 1;   // within its part, from 1
  int number = 1;  // within the round, from 1
  int home = 0;    // team that is blue in the first leg; or no_team or unknown_team
  int away = 0;
  int legs = 2;  // a tie of a knockout that is level after them gets one more
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

// The largest number of legs of a tie: the regular ones, and one that decides a level tie.
inline constexpr int max_legs = legs_per_fixture + 1;

// Returns a schedule by the circle method in which every pair meets once. Every team plays at most
// once in a round; with an odd number of teams one has a bye. The numbers of home and away fixtures
// of a team differ by at most one.
std::vector<Fixture> round_robin(int teams);

// Returns a schedule in which every pair plays `legs` legs, in fixtures of two legs and, if `legs`
// is odd, one of a single leg. Home and away are swapped from one repetition to the next.
std::vector<Fixture> round_robin(int teams, int legs);

// Returns the seed of all legs of a fixture. It depends on the league's seed and on the two teams,
// not on the order of play.
std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture);

}  // namespace mirocup::league
