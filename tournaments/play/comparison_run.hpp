// SPDX-License-Identifier: MIT
//
// Plays teams against each other until the test of comparison.hpp decides about each pair. A
// fixture is two legs of one seed with swapped colours; each fixture has a different seed. Fixtures
// are counted in the order of their numbers, so the answer does not depend on the number of jobs.
//
// Equal legs prove nothing. Two legs with goals differ if goals fell in different ticks or for
// different colours. Two legs without goals differ if their state hashes differ. No claim is made
// while fewer than half of the fixtures of a pair differ from each other. The two legs of one
// fixture may be equal, because a team that meets itself has the same luck in both legs.
//
// If legs are kept, the folder holds comparison.json, which describes the run, and the record of
// every leg. A run with equal settings and the same folder uses the kept legs and plays only the
// missing legs.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/match/goal_credit.hpp"
#include "system/commands.hpp"
#include "system/files.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/table/comparison.hpp"
#include "tournaments/table/rating.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mirocup::league {

struct ComparisonRun {
  std::vector<std::string> teams;  // texts of compared_team(); at least two
  bool all_pairs = false;          // false: the first team against each other team
  RobotLeague league = RobotLeague::small;
  double half_s = 0.0;             // length of a half, s; 0: as in the rules
  std::string conditions;          // a preset; "": the default of a match
  std::vector<std::string> terms;  // further options of `mirocup match`: the terms of a league
  std::uint64_t seed = 1;
  int jobs = 0;             // 0: one for each processor
  int max_fixtures = 4000;  // after so many fixtures a pair's answer is "undecided"
  bool plays_all = false;   // true: plays max_fixtures for each pair, decided or not
  std::string folder;       // the folder for records; must exist
  bool keeps_legs = false;  // false: removes a record as soon as it is read
  ComparisonOptions test;
};

// A team of a comparison: a library or the name of a house team, and its parameters.
struct ComparedTeam {
  std::string team;
  std::vector<std::string> parameters;  // KEY=VALUE
};

// Reads a team from TEAM, followed by :KEY=VALUE for each parameter.
ComparedTeam compared_team(const std::string& text);

// The data of a leg for a comparison, in the order of the pair's teams.
struct ComparedLeg {
  std::array<int, 2> score{};
  std::array<std::map<match::GoalKind, int>, 2> goals;  // without goals given by a forfeit
  std::array<int, 2> faults{};                          // 1: the team forfeited
  bool both_lose = false;                               // a double forfeit
  std::string trajectory;                               // text that is equal for equal legs
  std::string record;                                   // path of the record, if legs are kept
};

// The fixtures between two teams, and the answer about the two.
struct PairComparison {
  std::array<int, 2> teams{};  // indices into ComparisonRun::teams
  ComparisonVerdict verdict = ComparisonVerdict::undecided;
  bool is_of_copies = false;  // true: no claim, as fewer than half of the fixtures differ
  ScoreSequence scores;
  std::vector<std::array<ComparedLeg, 2>> fixtures;
  std::set<std::string> trajectories;  // the texts of all different legs
  std::set<std::string> courses;       // the texts of all different fixtures

  int legs() const { return 2 * static_cast<int>(fixtures.size()); }
  int distinct_legs() const { return static_cast<int>(trajectories.size()); }
};

// Returns the seed of a fixture (from 0) of two teams.
std::uint64_t comparison_seed(const ComparisonRun& run, const std::array<int, 2>& teams,
                              int fixture);

// Adds a fixture to a pair and decides about the pair; with `plays_all`, decides only at the last
// fixture.
void count_fixture(PairComparison& pair, const std::array<ComparedLeg, 2>& legs,
                   const ComparisonRun& run);

// Returns everything on which the legs of a run depend: teams with the digests of their libraries,
// the behaviour of this program, and the settings of the game. The error is about a library that
// cannot be read.
Result<nlohmann::ordered_json> comparison_identity(system::Files& files, const ComparisonRun& run);

// Returns the number of fixtures of two teams, from the first one on, of which the folder of the
// run has both legs. `teams` are indices into ComparisonRun::teams.
int kept_fixtures(system::Files& files, const ComparisonRun& run, const std::array<int, 2>& teams);

// True if the pair needs no further fixtures.
bool is_over(const PairComparison& pair, const ComparisonRun& run);

// Returns the results of a fixture; `between` has the pair's teams and their entries.
FixtureResults results_of(const std::array<ComparedLeg, 2>& legs, const LegResult& between);

// Returns the strengths of all teams, fitted to all fixtures.
Ratings rate(const ComparisonRun& run, const std::vector<PairComparison>& pairs);

// Adds the options --league, --half and --conditions of a comparison.
void add_terms(const system::Command& command, std::string& league, ComparisonRun& run);

// Plays all fixtures in child processes, and returns the pairs in the order of their teams. Errors:
// Errc::input if a library cannot play, or if the folder holds another comparison; Errc::host if a
// leg fails; Errc::interrupted.
Result<std::vector<PairComparison>> run_comparison(system::Files& files, const ComparisonRun& run,
                                                   ProgressReporter& progress);

}  // namespace mirocup::league
