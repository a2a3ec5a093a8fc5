// SPDX-License-Identifier: MIT
#include "tournaments/table/rating.hpp"

#include "core/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mirocup::league {

namespace {

constexpr int max_iterations = 200;
constexpr double converged = 1e-4;  // relative change of a strength
constexpr double scale = 400.0;

// The results of two teams in a fixture.
struct PairResults {
  int home = 0;
  int away = 0;
  double home_wins = 0.0;
  double away_wins = 0.0;
  double draws = 0.0;
};

PairResults pair_results(const FixtureResults& fixture) {
  PairResults pair;
  for (const LegResult& leg : fixture) {
    pair.home = leg.home;
    pair.away = leg.away;
    if (leg.both_lose) continue;
    pair.home_wins += leg.home_goals > leg.away_goals ? 1.0 : 0.0;
    pair.away_wins += leg.home_goals < leg.away_goals ? 1.0 : 0.0;
    pair.draws += leg.home_goals == leg.away_goals ? 1.0 : 0.0;
  }
  return pair;
}

// Maximum likelihood by Hunter's MM algorithm (2004), in which every step increases the likelihood.
class StrengthFit {
 public:
  explicit StrengthFit(int teams) : g_(teams, 1.0) {}

  void run(const std::vector<PairResults>& pairs, const std::vector<double>& double_forfeits) {
    const std::size_t teams = g_.size();
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      // The virtual team: a win and a loss for each team.
      std::vector<double> wins(teams, 1.0);
      std::vector<double> weight(teams);
      for (std::size_t i = 0; i < teams; ++i)
        weight[i] = (2.0 + double_forfeits[i]) / (g_[i] + 1.0);
      double draws = 0.0;
      double expected = 0.0;  // expected number of draws, divided by v
      for (const PairResults& p : pairs) {
        const double played = p.home_wins + p.away_wins + p.draws;
        const double root = std::sqrt(g_[p.home] * g_[p.away]);
        const double all = g_[p.home] + g_[p.away] + v_ * root;
        wins[p.home] += p.home_wins + 0.5 * p.draws;
        wins[p.away] += p.away_wins + 0.5 * p.draws;
        weight[p.home] += played * (1.0 + 0.5 * v_ * root / g_[p.home]) / all;
        weight[p.away] += played * (1.0 + 0.5 * v_ * root / g_[p.away]) / all;
        draws += p.draws;
        expected += played * root / all;
      }
      double change = 0.0;
      for (std::size_t i = 0; i < teams; ++i) {
        const double next = wins[i] / weight[i];
        change = std::max(change, std::abs(next / g_[i] - 1.0));
        g_[i] = next;
      }
      if (expected > 0.0) v_ = draws / expected;
      if (change < converged) break;
    }
  }

  std::vector<double> values() const {
    std::vector<double> values;
    for (const double g : g_) values.push_back(scale * std::log10(g));
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                        static_cast<double>(std::max<std::size_t>(1, values.size()));
    for (double& value : values) value -= mean;
    return values;
  }

 private:
  std::vector<double> g_;
  double v_ = 1.0;
};

std::vector<double> forfeits_of(int teams, const FixtureResults& fixture, double times,
                                std::vector<double> sum) {
  sum.resize(teams, 0.0);
  for (const LegResult& leg : fixture) {
    if (!leg.both_lose) continue;
    sum[leg.home] += times;
    sum[leg.away] += times;
  }
  return sum;
}

}  // namespace

std::vector<Strength> strengths(int teams, const std::vector<FixtureResults>& fixtures,
                                const RatingOptions& options) {
  std::vector<PairResults> pairs;
  std::vector<double> forfeits(teams, 0.0);
  for (const FixtureResults& fixture : fixtures) {
    pairs.push_back(pair_results(fixture));
    forfeits = forfeits_of(teams, fixture, 1.0, std::move(forfeits));
  }
  StrengthFit fit(teams);
  fit.run(pairs, forfeits);
  std::vector<Strength> result;
  for (const double value : fit.values()) result.push_back({value, value, value});
  if (options.resamples == 0 || fixtures.empty()) return result;

  std::vector<std::vector<double>> samples(teams);
  Random random(options.seed);
  for (int i = 0; i < options.resamples; ++i) {
    std::vector<double> times(pairs.size(), 0.0);
    for (std::size_t k = 0; k < pairs.size(); ++k) times[random.below(pairs.size())] += 1.0;
    std::vector<PairResults> drawn;
    std::vector<double> drawn_forfeits(teams, 0.0);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (times[k] == 0.0) continue;
      PairResults pair = pairs[k];
      pair.home_wins *= times[k];
      pair.away_wins *= times[k];
      pair.draws *= times[k];
      drawn.push_back(pair);
      drawn_forfeits = forfeits_of(teams, fixtures[k], times[k], std::move(drawn_forfeits));
    }
    StrengthFit again = fit;  // starts close to its solution
    again.run(drawn, drawn_forfeits);
    const std::vector<double> values = again.values();
    for (int team = 0; team < teams; ++team) samples[team].push_back(values[team]);
  }
  for (int team = 0; team < teams; ++team) {
    std::sort(samples[team].begin(), samples[team].end());
    const std::size_t tail = samples[team].size() / 40;  // 2.5 %
    result[team].low = samples[team][tail];
    result[team].high = samples[team][samples[team].size() - 1 - tail];
  }
  return result;
}

}  // namespace mirocup::league
