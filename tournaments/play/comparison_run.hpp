// SPDX-License-Identifier: MIT
//
// Plays teams against each other until the test of comparison.hpp decides about each pair. A
// fixture is two legs of one seed with swapped colours; every fixture has another seed. Fixtures
// count in their order, so the answer does not depend on the number of jobs.
//
// Copies of a leg prove nothing. Two legs with goals differ if their goals fell in different ticks
// or for different colours. Two legs without goals differ if their state hashes differ. There is no
// claim while fewer than half of the fixtures of a pair differ from each other. The two legs of one
// fixture may be equal: a team that meets itself has the same luck in both.
//
// If legs are kept, the folder holds comparison.json, which describes the run, and the record of
// every leg. The same run with the same folder uses these legs and plays the missing ones.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/match/goal_credit.hpp"
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
  League league = League::small;
  double half_s = 0.0;     // seconds of a half; 0: as in the rules
  std::string conditions;  // a preset; "": the default of a match
  std::uint64_t seed = 1;
  int jobs = 0;             // 0: one for each processor
  int max_fixtures = 4000;  // of a pair; then the answer is "undecided"
  bool plays_all = false;   // plays max_fixtures for each pair, decided or not
  std::string folder;       // for records; must exist
  bool keeps_legs = false;  // false: removes a record as soon as it is read
  ComparisonOptions test;
};

// A team of a comparison: a library or the name of a house team, and its parameters.
struct ComparedTeam {
  std::string team;
  std::vector<std::string> parameters;  // KEY=VALUE
};

// Reads TEAM or TEAM:KEY=VALUE, with as many further :KEY=VALUE as there are parameters.
ComparedTeam compared_team(const std::string& text);

// The data of a leg for a comparison; the teams are those of its pair.
struct ComparedLeg {
  std::array<int, 2> score{};
  std::array<std::map<match::GoalKind, int>, 2> goals;  // without goals given by a forfeit
  std::array<int, 2> faults{};                          // 1: this team forfeited
  bool both_lose = false;                               // a double forfeit
  std::string trajectory;                               // equal for copies
};

// The fixtures of two teams.
struct PairComparison {
  std::array<int, 2> teams{};  // indices into ComparisonRun::teams
  ComparisonVerdict verdict = ComparisonVerdict::undecided;
  bool is_of_copies = false;  // fewer than half of the fixtures are different: nothing is claimed
  ScoreSequence scores;
  std::vector<std::array<ComparedLeg, 2>> fixtures;
  std::set<std::string> trajectories;  // one for each different leg
  std::set<std::string> courses;       // one for each different fixture

  int legs() const { return 2 * static_cast<int>(fixtures.size()); }
  int distinct_legs() const { return static_cast<int>(trajectories.size()); }
};

// The seed of a fixture (from 0) of two teams.
std::uint64_t comparison_seed(const ComparisonRun& run, const std::array<int, 2>& teams,
                              int fixture);

// Adds a fixture to a pair and decides about it; with `plays_all` only the last fixture decides.
void count_fixture(PairComparison& pair, const std::array<ComparedLeg, 2>& legs,
                   const ComparisonRun& run);

// Returns everything on which the legs of a run depend: teams with the digests of their libraries,
// the game, and its settings. The error is that of a library that cannot be read.
Result<nlohmann::ordered_json> comparison_identity(system::Files& files, const ComparisonRun& run);

// True if no more fixtures of the pair are needed.
bool is_over(const PairComparison& pair, const ComparisonRun& run);

// Returns the strengths of all teams, fitted to all fixtures.
Ratings rate(const ComparisonRun& run, const std::vector<PairComparison>& pairs);

// Plays the fixtures in child processes, and returns the pairs in the order of their teams. Errors:
// Errc::input if a library cannot play, or if the folder holds another comparison; Errc::host if a
// leg fails; Errc::interrupted.
Result<std::vector<PairComparison>> run_comparison(system::Files& files, const ComparisonRun& run,
                                                   ProgressReporter& progress);

}  // namespace mirocup::league
