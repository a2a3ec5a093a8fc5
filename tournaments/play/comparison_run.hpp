// SPDX-License-Identifier: MIT
//
// Plays two libraries against each other until the sequential test decides which is better.
// Fixtures are counted in the order of their numbers, so the answer does not depend on the number
// of jobs.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "server/system/files.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/table/comparison.hpp"

#include <array>
#include <string>

namespace mirocup::league {

struct ComparisonRun {
  std::array<std::string, 2> teams;  // libraries, or names of house teams
  League league = League::small;
  double half_s = 0.0;  // duration of a half in seconds; 0: that of the rules
  std::uint64_t seed = 1;
  int jobs = 0;            // 0: one for each processor
  int max_fixtures = 200;  // limit after which the verdict is `undecided`
  std::string folder;      // for records; must exist
  ComparisonOptions test;
};

struct ComparisonResult {
  ComparisonVerdict verdict = ComparisonVerdict::undecided;
  int first_wins = 0;
  int second_wins = 0;
  int level = 0;
};

// Runs the comparison and returns its verdict with the counts behind it. Blocks until it is
// finished.
Result<ComparisonResult> run_comparison(system::Files& files, const ComparisonRun& run,
                                        ProgressReporter& progress);

}  // namespace mirocup::league
