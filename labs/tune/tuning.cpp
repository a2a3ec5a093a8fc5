// SPDX-License-Identifier: MIT
#include "labs/tune/tuning.hpp"

#include "labs/tune/cma_es.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace mirocup::league {

namespace {

// The search runs in a cube of side 1.
constexpr double first_step = 0.25;

// The ratio of the variance of candidates to what chance gives, below which more fixtures are
// played, and above which fewer are.
constexpr double much_noise = 2.5;
constexpr double little_noise = 8.0;

// Folds a number at 0 and at 1, so that the search sees a function without borders.
double folded(double x) {
  return std::abs(std::remainder(x, 2.0));
}

// Rounded to six digits, as a person writes it in --param.
double readable(double value) {
  return std::strtod(system::formatted("%.6g", value).c_str(), nullptr);
}

std::vector<double> values_of(const TuningOptions& options, const Eigen::VectorXd& x) {
  std::vector<double> values;
  for (std::size_t i = 0; i < options.parameters.size(); ++i) {
    const TunedParameter& p = options.parameters[i];
    values.push_back(readable(p.low + (p.high - p.low) * folded(x[static_cast<int>(i)])));
  }
  return values;
}

double mean_goals(const std::vector<Mark>& marks) {
  double sum = 0.0;
  for (const Mark& mark : marks) sum += mark.goals;
  return sum / static_cast<double>(std::max<std::size_t>(marks.size(), 1));
}

Mark mean_mark(const std::vector<Mark>& marks) {
  Mark mean;
  for (const Mark& mark : marks) {
    mean.goals += mark.goals / static_cast<double>(marks.size());
    mean.points += mark.points / static_cast<double>(marks.size());
  }
  return mean;
}

// What the candidates of a generation say about each other: two-way analysis of variance, in which
// a fixture that is hard for all candidates is no noise.
struct Spread {
  double noise = 0.0;  // variance of a candidate's mean by chance
  double ratio = 1.0;  // of the variance of the candidates' means to that
};

Spread spread_of(const std::vector<std::vector<Mark>>& marks) {
  std::size_t fixtures = marks.front().size();
  for (const auto& of_one : marks) fixtures = std::min(fixtures, of_one.size());
  const double n = static_cast<double>(fixtures);
  const double k = static_cast<double>(marks.size());
  if (fixtures < 2) return {};
  std::vector<double> by_candidate(marks.size());
  std::vector<double> by_fixture(fixtures);
  double all = 0.0;
  for (std::size_t c = 0; c < marks.size(); ++c) {
    for (std::size_t f = 0; f < fixtures; ++f) {
      const double goals = marks[c][f].goals;
      by_candidate[c] += goals / n;
      by_fixture[f] += goals / k;
      all += goals / (n * k);
    }
  }
  double residual = 0.0;
  double between = 0.0;
  for (std::size_t c = 0; c < marks.size(); ++c) {
    between += (by_candidate[c] - all) * (by_candidate[c] - all) / (k - 1.0);
    for (std::size_t f = 0; f < fixtures; ++f) {
      const double rest = marks[c][f].goals - by_candidate[c] - by_fixture[f] + all;
      residual += rest * rest / ((k - 1.0) * (n - 1.0));
    }
  }
  const double noise = residual / n;
  return {.noise = noise, .ratio = noise > 0.0 ? between / noise : between > 0.0 ? 1e9 : 1.0};
}

std::vector<double> differences(const std::vector<Mark>& after, const std::vector<Mark>& before,
                                double Mark::*member) {
  std::vector<double> result;
  for (std::size_t i = 0; i < std::min(after.size(), before.size()); ++i) {
    result.push_back(after[i].*member - before[i].*member);
  }
  return result;
}

// The 97.5 % point of Student's distribution, by the expansion of Cornish and Fisher (Abramowitz
// and Stegun 26.7.5): 0.1 % off at 8 degrees of freedom, and nearer with more.
double student(double degrees) {
  const double z = 1.959963984540054;
  const double z3 = z * z * z;
  const double z5 = z3 * z * z;
  const double z7 = z5 * z * z;
  return z + (z3 + z) / (4.0 * degrees) +
         (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * degrees * degrees) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * degrees * degrees * degrees);
}

}  // namespace

Gain mean_with_interval(const std::vector<double>& numbers) {
  const double n = static_cast<double>(numbers.size());
  if (numbers.size() < 2) return {};
  const double mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / n;
  double variance = 0.0;
  for (const double x : numbers) variance += (x - mean) * (x - mean) / (n - 1.0);
  if (variance <= 0.0) return {mean, std::min(mean, 0.0), std::max(mean, 0.0)};
  const double half = student(n - 1.0) * std::sqrt(variance / n);
  return {mean, mean - half, mean + half};
}

Result<TuningResult> tune(const TuningOptions& options, const PlayFixtures& play,
                          const TellGeneration& tell) {
  const auto n = static_cast<Eigen::Index>(options.parameters.size());
  CmaEs search(Eigen::VectorXd::Constant(n, 0.5), first_step, mix_seed(options.seed));
  TuningResult result;
  int fixtures = options.fixtures;
  int played = 0;
  for (int g = 0; g < options.generations; ++g) {
    const std::uint64_t seed = mix_seed(mix_seed(options.seed) + static_cast<std::uint64_t>(g));
    const auto candidates = search.ask();
    std::vector<std::vector<Mark>> marks;
    std::vector<double> goals;
    for (const Eigen::VectorXd& x : candidates) {
      MIROCUP_TRY(auto of_one, play(values_of(options, x), seed, fixtures));
      goals.push_back(mean_goals(of_one));
      played += fixtures;
      marks.push_back(std::move(of_one));
    }
    search.tell(candidates, goals);
    const Spread spread = spread_of(marks);
    Generation& now = result.course.emplace_back();
    now.mean = values_of(options, search.mean());
    const Eigen::VectorXd deviations = search.deviations();
    for (Eigen::Index i = 0; i < n; ++i) {
      const TunedParameter& p = options.parameters[static_cast<std::size_t>(i)];
      now.deviation.push_back((p.high - p.low) * std::min(deviations[i], 1.0));
    }
    now.goals =
        std::accumulate(goals.begin(), goals.end(), 0.0) / static_cast<double>(goals.size());
    now.error = std::sqrt(spread.noise);
    now.fixtures = fixtures;
    now.played = played;
    MIROCUP_TRY_VOID(tell(result.course));
    if (spread.ratio < much_noise) fixtures = std::min(options.most_fixtures, 2 * fixtures);
    if (spread.ratio > little_noise) fixtures = std::max(options.fixtures, fixtures / 2);
  }
  result.values = values_of(options, search.mean());
  const std::uint64_t fresh = mix_seed(~mix_seed(options.seed));
  MIROCUP_TRY(const auto after, play(result.values, fresh, options.test_fixtures));
  MIROCUP_TRY(const auto before, play(std::nullopt, fresh, options.test_fixtures));
  result.after = mean_mark(after);
  result.before = mean_mark(before);
  const auto points = differences(after, before, &Mark::points);
  result.test_fixtures = static_cast<int>(points.size());
  result.points = mean_with_interval(points);
  result.goals = mean_with_interval(differences(after, before, &Mark::goals));
  return result;
}

}  // namespace mirocup::league
