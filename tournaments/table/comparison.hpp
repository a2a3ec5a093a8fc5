// SPDX-License-Identifier: MIT
//
// Which of two is better? A sequential test (Wald 1945): play until it can be said, and no longer.
// Fixtures of two legs with swapped ends count as one trial; level ones say nothing. Both answers
// are wrong with at most the given probability if the better one wins at least the given share of
// the fixtures that are not level.
#pragma once

#include <cmath>

namespace mirocup::league {

struct ComparisonOptions {
  double share = 0.6;   // of the fixtures that are not level; above one half
  double error = 0.05;  // probability of the wrong answer
};

enum class ComparisonVerdict { undecided, first, second };

// The lead, in fixtures won, that decides: the bound of the likelihood ratio between the two answers.
inline int deciding_lead(const ComparisonOptions& options) {
  const double bound = std::log((1.0 - options.error) / options.error);
  const double step = std::log(options.share / (1.0 - options.share));
  return static_cast<int>(std::ceil(bound / step - 1e-9));
}

inline ComparisonVerdict verdict(int first_wins, int second_wins,
                                 const ComparisonOptions& options) {
  const int lead = first_wins - second_wins;
  if (lead >= deciding_lead(options)) return ComparisonVerdict::first;
  if (-lead >= deciding_lead(options)) return ComparisonVerdict::second;
  return ComparisonVerdict::undecided;
}

}  // namespace mirocup::league
