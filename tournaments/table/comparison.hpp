// SPDX-License-Identifier: MIT
//
// Decides which of two teams is better by a sequential probability ratio test (Wald 1945), which
// stops as soon as the results suffice. A fixture of two legs with swapped colours is one trial;
// level fixtures are ignored. Either answer is wrong with at most the probability `error` if the
// better team wins at least `share` of the fixtures that are not level.
#pragma once

#include "core/base/assert.hpp"

#include <cmath>

namespace mirocup::league {

struct ComparisonOptions {
  double share = 0.6;   // of the fixtures that are not level; in (0.5, 1)
  double error = 0.05;  // probability of a wrong answer
};

enum class ComparisonVerdict { undecided, first, second };

// Returns the lead, in fixtures won, at which the likelihood ratio of the two answers reaches its
// bound.
inline int deciding_lead(const ComparisonOptions& options) {
  MIROCUP_ASSERT(options.share > 0.5 && options.share < 1.0);
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
