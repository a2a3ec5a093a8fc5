// SPDX-License-Identifier: MIT
//
// A sequential probability ratio test (Wald 1945) that decides which of two strategies is better
// and needs no more fixtures than the decision takes. A trial is a fixture of two legs with swapped
// ends; a level fixture is ignored. Either answer is wrong with at most the probability `error` if
// the better strategy wins at least the share `share` of the fixtures that are not level.
#pragma once

#include <cmath>

namespace mirocup::league {

struct ComparisonOptions {
  double share = 0.6;   // of the fixtures that are not level; above one half
  double error = 0.05;  // probability of the wrong answer
};

enum class ComparisonVerdict { undecided, first, second };

// Returns the lead, in fixtures won, at which the test decides: there the likelihood ratio of the
// two answers reaches Wald's bound.
inline int deciding_lead(const ComparisonOptions& options) {
  const double bound = std::log((1.0 - options.error) / options.error);
  const double step = std::log(options.share / (1.0 - options.share));
  return static_cast<int>(std::ceil(bound / step - 1e-9));
}

// Returns the decision after these numbers of won fixtures, or `undecided` if more must be played.
inline ComparisonVerdict verdict(int first_wins, int second_wins,
                                 const ComparisonOptions& options) {
  const int lead = first_wins - second_wins;
  if (lead >= deciding_lead(options)) return ComparisonVerdict::first;
  if (-lead >= deciding_lead(options)) return ComparisonVerdict::second;
  return ComparisonVerdict::undecided;
}

}  // namespace mirocup::league
