// SPDX-License-Identifier: MIT
//
// The simulated part of tests/bench/contest: how often the statements of statistics hold where the
// truth is known. Prints one JSON object for each line.
//
// contest_figures leagues COUNT: leagues of teams whose strengths are known; how often the 95 %
// intervals hold the truth, for all teams and for the best and the worst.
//
// contest_figures comparisons COUNT MOST: reads the half points (0 to 4) of played fixtures from
// standard input. Draws the fixtures of COUNT comparisons from them, and counts wrong claims.
#include "core/base/random.hpp"
#include "tournaments/table/comparison.hpp"
#include "tournaments/table/rating.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

using namespace mirocup;
using namespace mirocup::league;

namespace {

// How the true strengths of a league are chosen.
enum class Spread { even, normal };

// Even: equally spaced, and `spread` from the best to the worst. Normal: drawn, with that standard
// deviation. The best is first, and the mean is 0.
std::vector<double> true_strengths(int teams, double spread, Spread kind, Random& random) {
  std::vector<double> truth;
  for (int i = 0; i < teams; ++i) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
    const double normal = radius * std::cos(2.0 * 3.14159265358979 * random.uniform());
    truth.push_back(spread * (kind == Spread::even ? 0.5 - double(i) / (teams - 1) : normal));
  }
  std::sort(truth.rbegin(), truth.rend());
  const double mean = std::accumulate(truth.begin(), truth.end(), 0.0) / teams;
  for (double& strength : truth) strength -= mean;
  return truth;
}

// A leg between two teams of these strengths; one leg in five between equal teams is a draw.
LegResult played(int home, int away, double difference, Random& random) {
  const double win = std::pow(10.0, difference / 400.0);
  const double draw = 0.5 * std::sqrt(win);
  const double drawn = random.uniform() * (win + 1.0 + draw);
  LegResult leg;
  leg.home = home;
  leg.away = away;
  leg.home_goals = drawn < win ? 1 : 0;
  leg.away_goals = drawn >= win && drawn < win + 1.0 ? 1 : 0;
  return leg;
}

// Every team meets each other in one fixture of two legs.
std::vector<FixtureResults> season(const std::vector<double>& truth, Random& random) {
  std::vector<FixtureResults> fixtures;
  for (int i = 0; i < static_cast<int>(truth.size()); ++i) {
    for (int j = 0; j < i; ++j) {
      const double difference = truth[i] - truth[j];
      fixtures.push_back({played(i, j, difference, random), played(j, i, -difference, random)});
    }
  }
  return fixtures;
}

void leagues(int count, int teams, double spread, Spread kind) {
  Random random(mix_seed(static_cast<std::uint64_t>(spread) * 1000 + teams) ^
                static_cast<std::uint64_t>(kind));
  int held = 0;
  int held_at_the_ends = 0;
  double width = 0.0;
  for (int i = 0; i < count; ++i) {
    const std::vector<double> truth = true_strengths(teams, spread, kind, random);
    const Ratings ratings = rate(teams, season(truth, random));
    for (int team = 0; team < teams; ++team) {
      const Strength& strength = ratings.strengths[team];
      const int holds = strength.low <= truth[team] && truth[team] <= strength.high ? 1 : 0;
      held += holds;
      if (team == 0 || team == teams - 1) held_at_the_ends += holds;
      width += strength.high - strength.low;
    }
  }
  std::printf(
      "{\"teams\": %d, \"spread\": %.0f, \"kind\": \"%s\", \"covered\": %.4f, "
      "\"covered_at_the_ends\": %.4f, \"width\": %.0f}\n",
      teams, spread, kind == Spread::even ? "even" : "normal", double(held) / (count * teams),
      double(held_at_the_ends) / (2 * count), width / (count * teams));
  std::fflush(stdout);
}

// How the fixtures of a simulated comparison come from the pool.
struct Drawing {
  const char* name;
  bool is_turned;    // half of the fixtures, by a coin, as the other team saw them: equal teams
  double elo = 0.0;  // by which the first team is then better: some of the fixtures are won by it
};

int drawn(const std::vector<int>& pool, const Drawing& drawing, Random& random) {
  if (random.uniform() < 2.0 * share_of(drawing.elo) - 1.0) return ScoreSequence::most_points;
  const int points = pool[random.below(pool.size())];
  return drawing.is_turned && random.coin() ? ScoreSequence::most_points - points : points;
}

// Whether a claim is false where the first team's expected share is `share`.
bool is_wrong(ComparisonVerdict verdict, double share) {
  const double apart = std::abs(elo_of(share));
  switch (verdict) {
    case ComparisonVerdict::first:
      return share <= 0.5;
    case ComparisonVerdict::second:
      return share >= 0.5;
    case ComparisonVerdict::equal:
      return apart >= ComparisonOptions{}.equal_elo - 1e-6;  // at the bound, but for rounding
    case ComparisonVerdict::undecided:
      break;
  }
  return false;
}

void comparisons(int count, int most, const std::vector<int>& pool, const Drawing& drawing) {
  Random random(mix_seed(static_cast<std::uint64_t>(drawing.elo) * 2 + drawing.is_turned));
  const double mean = std::accumulate(pool.begin(), pool.end(), 0.0) /
                      (double(pool.size()) * ScoreSequence::most_points);
  const double share = drawing.is_turned ? share_of(drawing.elo) : mean;
  std::array<int, enum_names<ComparisonVerdict>.size()> verdicts{};
  int wrong = 0;
  std::vector<int> fixtures;
  for (int i = 0; i < count; ++i) {
    ScoreSequence scores;
    ComparisonVerdict verdict = ComparisonVerdict::undecided;
    while (verdict == ComparisonVerdict::undecided && scores.fixtures() < most) {
      scores.add(drawn(pool, drawing, random));
      verdict = scores.verdict();
    }
    ++verdicts[static_cast<std::size_t>(verdict)];
    wrong += is_wrong(verdict, share) ? 1 : 0;
    fixtures.push_back(scores.fixtures());
  }
  std::sort(fixtures.begin(), fixtures.end());
  std::printf(
      "{\"drawing\": \"%s\", \"elo\": %.1f, \"comparisons\": %d, \"wrong\": %d, \"first\": %d, "
      "\"second\": %d, \"equal\": %d, \"undecided\": %d, \"median_fixtures\": %d, "
      "\"slowest_tenth\": %d}\n",
      drawing.name, elo_of(share), count, wrong, verdicts[1], verdicts[2], verdicts[3], verdicts[0],
      fixtures[fixtures.size() / 2], fixtures[fixtures.size() * 9 / 10]);
  std::fflush(stdout);
}

std::vector<int> read_pool() {
  std::vector<int> pool;
  for (int points = 0; std::scanf("%d", &points) == 1;)
    pool.push_back(std::clamp(points, 0, ScoreSequence::most_points));
  return pool;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[1] : "";
  if (what == "leagues") {
    for (const Spread kind : {Spread::even, Spread::normal}) {
      for (const int teams : {8, 20}) {
        for (const double spread : {100.0, 200.0, 400.0})
          leagues(std::atoi(argv[2]), teams, spread, kind);
      }
    }
    return EXIT_SUCCESS;
  }
  if (what == "comparisons" && argc > 3) {
    const std::vector<int> pool = read_pool();
    if (pool.empty()) return 2;
    for (const Drawing& drawing : {Drawing{"as played", false}, Drawing{"equal", true},
                                   Drawing{"20 Elo", true, 20.0}, Drawing{"60 Elo", true, 60.0}})
      comparisons(std::atoi(argv[2]) / 4, std::atoi(argv[3]), pool, drawing);
    return EXIT_SUCCESS;
  }
  std::fprintf(stderr, "usage: contest_figures leagues COUNT | comparisons COUNT MOST < POINTS\n");
  return 2;
}
