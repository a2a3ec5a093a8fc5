// SPDX-License-Identifier: MIT
//
// The schedule: which teams meet, in which rounds. Ids and seeds of fixtures follow from the
// schedule alone, so the results of a league do not depend on the order of its legs or on the
// number of jobs. Teams are indices into the league's list of teams.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::league {

// Values that stand for a team.
inline constexpr int no_team = -1;       // a bye, or a place that stays empty
inline constexpr int unknown_team = -2;  // the team is known when another fixture is over

// The source of a team of a fixture.
struct TeamSource {
  enum class Kind {
    team,    // `index` is the team, or no_team
    winner,  // of the fixture with the index `index` in the schedule
    loser,   // of the fixture with the index `index` in the schedule
    place,   // number `place` in the table of the group `index`, both from 0
  };
  Kind kind = Kind::team;
  int index = no_team;
  int place = 0;
};

// The part of a league to which a fixture belongs: the table of all teams, the table of a group, or
// the knockout.
enum class Part { table, group, knockout };

// Two teams and their legs. All legs have one seed, and the teams swap colours from leg to leg.
struct Fixture {
  int round = 1;   // from 1 in each part of the league
  int number = 1;  // from 1 in each round
  int home = 0;    // blue in the first leg; may be no_team or unknown_team
  int away = 0;
  int legs = 2;  // a tie of a knockout that is level after these legs has one leg more
  Part part = Part::table;
  int group = 0;             // number of the group, from 1; Part::group only
  TeamSource home_source{};  // Part::knockout only
  TeamSource away_source{};

  // Returns the id, unique in the league: "r2-f1", "g3-r2-f1", "k2-f1"; and the name of the round
  // for people, "r2" or "k2", which is that of all groups.
  std::string id() const;
  std::string round_key() const;
  // Orders rounds: those of a knockout come after all others.
  std::pair<bool, int> round_order() const { return {part == Part::knockout, round}; }

  // Returns the teams that are blue and yellow in a leg (from 1).
  std::pair<int, int> colours(int leg) const {
    return is_home_blue(leg) ? std::pair(home, away) : std::pair(away, home);
  }
  static bool is_home_blue(int leg) { return leg % 2 == 1; }
  // True if both teams are known.
  bool has_both() const { return home >= 0 && away >= 0; }
  bool is_for_third_place() const { return home_source.kind == TeamSource::Kind::loser; }
};

inline constexpr int legs_per_fixture = 2;

// The most legs that a fixture can need: in a knockout a further leg decides a level tie.
inline constexpr int max_legs = legs_per_fixture + 1;

// Returns a fixture for every pair, by the circle method. In each round every team plays at most
// once; if the number of teams is odd, one team has a bye. The home and away fixtures of a team
// differ in number by at most one.
std::vector<Fixture> round_robin(int teams);

// Returns fixtures such that every pair plays `legs` legs: fixtures of two legs, and for an odd
// number of legs a last fixture of one leg. A pair that meets again swaps home and away.
std::vector<Fixture> round_robin(int teams, int legs);

// Returns the fixtures of a night (from 1) among some teams, all in one round with the night's
// number. Each team has `opponents` fixtures; 0: every pair meets. If the number of teams is odd,
// some teams have one fixture less. Over many nights every pair meets equally often.
std::vector<Fixture> night_fixtures(int night, const std::vector<int>& teams, int opponents);

// Returns the fixtures of a ladder for the new entry of `team` against at most `sample` other
// teams, drawn uniformly. `event` is the number of entries booked so far, including the new entry;
// it becomes the round of the fixtures. The same arguments give the same sample.
std::vector<Fixture> ladder_fixtures(int event, int team, const std::vector<int>& others,
                                     int sample, std::uint64_t league_seed);

// Returns the seed of all legs of a fixture, 53 bits. The seed depends only on the league's seed,
// the round and the teams.
std::uint64_t fixture_seed(std::uint64_t league_seed, const Fixture& fixture);

}  // namespace mirocup::league
