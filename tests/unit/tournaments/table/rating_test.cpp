// SPDX-License-Identifier: MIT
//
// Catches strengths that do not fit their results, intervals that miss the true strengths, and a
// sequential test that is wrong more often than its error probability.
#include "tournaments/table/rating.hpp"

#include "core/base/random.hpp"
#include "tests/unit/tournaments/leg_result.hpp"
#include "tournaments/table/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::league {
namespace {

// Returns random results of teams whose strengths are known.
std::vector<FixtureResults> season(const std::vector<double>& truth, int times, Random& random) {
  std::vector<FixtureResults> fixtures;
  for (int time = 0; time < times; ++time) {
    for (int a = 0; a < static_cast<int>(truth.size()); ++a) {
      for (int b = 0; b < a; ++b) {
        FixtureResults fixture;
        for (int i = 0; i < 2; ++i) {
          const double win = 1.0 / (1.0 + std::pow(10.0, (truth[b] - truth[a]) / 400.0));
          const bool won = random.uniform() < win;
          fixture.push_back(leg_result(a, b, won ? 1 : 0, won ? 0 : 1));
        }
        fixtures.push_back(fixture);
      }
    }
  }
  return fixtures;
}

TEST(Strength, FindsTheStrengthsThatMadeTheResults) {
  Random random(1);
  const std::vector<double> truth{300.0, 100.0, 0.0, -100.0, -300.0};
  const auto found = strengths(5, season(truth, 200, random), {.resamples = 0});
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(found[i].value, truth[i], 40.0) << i;
}

TEST(Strength, HasIntervalsThatHoldTheTruth) {
  Random random(2);
  const std::vector<double> truth{200.0, 50.0, -50.0, -200.0};
  int inside = 0;
  int all = 0;
  for (int season_number = 0; season_number < 25; ++season_number) {
    const auto found = strengths(4, season(truth, 10, random), {.resamples = 80, .seed = 3});
    for (int i = 0; i < 4; ++i) {
      ++all;
      inside += found[i].low <= truth[i] && truth[i] <= found[i].high ? 1 : 0;
    }
  }
  EXPECT_GT(inside, all * 85 / 100) << "of " << all;
}

TEST(Strength, IsFiniteForWhoWonOrLostEverything) {
  const auto found = strengths(2, {{leg_result(0, 1, 5, 0), leg_result(0, 1, 9, 0)}}, {.seed = 1});
  EXPECT_GT(found[0].value, 0.0);
  EXPECT_LT(found[0].value, 1000.0);
  EXPECT_NEAR(found[0].value, -found[1].value, 1e-6);
}

TEST(Strength, CallsWhoOnlyDrewEqual) {
  const auto found = strengths(
      3, {{leg_result(0, 1, 1, 1)}, {leg_result(1, 2, 0, 0)}, {leg_result(2, 0, 2, 2)}}, {});
  for (const Strength& s : found) EXPECT_NEAR(s.value, 0.0, 1.0);
}

TEST(Strength, IsTheSameForTheSameSeed) {
  Random random(4);
  const auto fixtures = season({50.0, 0.0, -50.0}, 3, random);
  const auto one = strengths(3, fixtures, {.seed = 9});
  const auto again = strengths(3, fixtures, {.seed = 9});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(one[i].low, again[i].low);
    EXPECT_EQ(one[i].high, again[i].high);
  }
}

TEST(Comparison, IsWrongAsSeldomAsItSays) {
  const ComparisonOptions options;
  Random random(5);
  int wrong = 0;
  constexpr int trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    int first = 0;
    int second = 0;
    while (verdict(first, second, options) == ComparisonVerdict::undecided)
      ++(random.uniform() < options.share ? first : second);
    wrong += verdict(first, second, options) == ComparisonVerdict::second ? 1 : 0;
  }
  EXPECT_LT(wrong, trials * 0.06);
  EXPECT_EQ(deciding_lead({.share = 0.6, .error = 0.05}), 8);
}

}  // namespace
}  // namespace mirocup::league
