// SPDX-License-Identifier: MIT
#include "tournaments/table/comparison.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirocup::league {

namespace {

using Counts = std::array<int, ScoreSequence::most_points + 1>;

// The sizes of the bets fall by sqrt(2). The largest loses nine tenths of its capital at the worst
// result; the smallest is the best one for teams at 20 Elo from a bound, after thousands of
// fixtures.
constexpr int bets = 12;
constexpr double largest_bet = 0.9;

// Returns the logarithm of the capital of a gambler who bets that the expected share is above
// `share`, in (0, 1). It falls as `share` rises.
double log_capital(const Counts& counts, double share) {
  std::array<double, bets> logs{};
  double size = largest_bet;
  for (double& log : logs) {
    for (std::size_t points = 0; points < counts.size(); ++points) {
      const double gain = double(points) / ScoreSequence::most_points / share - 1.0;
      log += counts[points] * std::log1p(size * gain);
    }
    size /= std::sqrt(2.0);
  }
  const double top = *std::ranges::max_element(logs);
  double sum = 0.0;
  for (const double log : logs) sum += std::exp(log - top);
  return top + std::log(sum / bets);
}

// Whether the results refute that the expected share is `share` or less. Half of the error is for
// the other side.
bool is_above(const Counts& counts, double share, double error) {
  return log_capital(counts, share) >= std::log(2.0 / error);
}

// The results as the other team sees them.
Counts turned(Counts counts) {
  std::ranges::reverse(counts);
  return counts;
}

// Returns the largest share that is refuted as an upper bound; 0 if none is.
double lowest_share(const Counts& counts, double error) {
  double low = 0.0;
  double high = 1.0;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (is_above(counts, middle, error) ? low : high) = middle;
  }
  return low;
}

}  // namespace

int ScoreSequence::fixtures() const {
  return std::accumulate(counts_.begin(), counts_.end(), 0);
}

ComparisonVerdict ScoreSequence::verdict(const ComparisonOptions& options) const {
  MIROCUP_ASSERT(options.error > 0.0 && options.error < 1.0 && options.equal_elo > 0.0);
  const Counts other = turned(counts_);
  if (is_above(counts_, 0.5, options.error)) return ComparisonVerdict::first;
  if (is_above(other, 0.5, options.error)) return ComparisonVerdict::second;
  const double low = share_of(-options.equal_elo);
  if (is_above(counts_, low, options.error) && is_above(other, low, options.error))
    return ComparisonVerdict::equal;
  return ComparisonVerdict::undecided;
}

ComparisonInterval ScoreSequence::difference(const ComparisonOptions& options) const {
  double points = 0.0;
  for (int i = 0; i <= most_points; ++i) points += double(i) / most_points * counts_[i];
  const double share = (points + 0.25) / (fixtures() + 0.5);
  return {elo_of(share), elo_of(lowest_share(counts_, options.error)),
          -elo_of(lowest_share(turned(counts_), options.error))};
}

double share_of(double elo) {
  return 1.0 / (1.0 + std::pow(10.0, -elo / 400.0));
}

double elo_of(double share) {
  return 400.0 * std::log10(share / (1.0 - share));
}

}  // namespace mirocup::league
