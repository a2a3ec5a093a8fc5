// SPDX-License-Identifier: MIT
//
// Plays two libraries against each other until it can be said which is better. Fixtures count in
// their order, however many are played at once, so the answer does not depend on that.
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
  double half_s = 0.0;  // 0: as the rules say
  std::uint64_t seed = 1;
  int jobs = 0;            // 0: one for each processor
  int max_fixtures = 200;  // fixtures
  std::string folder;      // for records; exists
  ComparisonOptions test;
};

struct ComparisonResult {
  ComparisonVerdict verdict = ComparisonVerdict::undecided;
  int first_wins = 0;
  int second_wins = 0;
  int level = 0;
};

Result<ComparisonResult> run_comparison(system::Files& files, const ComparisonRun& run,
                                        ProgressReporter& progress);

}  // namespace mirocup::league
