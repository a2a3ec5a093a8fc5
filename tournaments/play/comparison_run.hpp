// SPDX-License-Identifier: MIT
//
// Plays two libraries against each other until the sequential test of comparison.hpp decides.
// Fixtures are counted in their order, so the answer does not depend on the number of jobs.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "system/files.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/table/comparison.hpp"

#include <array>
#include <string>

namespace mirocup::league {

struct ComparisonRun {
  std::array<std::string, 2> teams;  // libraries, or names of house teams
  League league = League::small;
  double half_s = 0.0;  // seconds of a half; 0: as in the rules
  std::uint64_t seed = 1;
  int jobs = 0;            // 0: one for each processor
  int max_fixtures = 200;  // after them the answer is "undecided"
  std::string folder;      // for records; must exist
  ComparisonOptions test;
};

struct ComparisonResult {
  ComparisonVerdict verdict = ComparisonVerdict::undecided;
  int first_wins = 0;
  int second_wins = 0;
  int level = 0;
};

// Plays the fixtures in child processes. Errors: Errc::input if a library cannot play; Errc::host
// if a leg fails; Errc::interrupted.
Result<ComparisonResult> run_comparison(system::Files& files, const ComparisonRun& run,
                                        ProgressReporter& progress);

}  // namespace mirocup::league
