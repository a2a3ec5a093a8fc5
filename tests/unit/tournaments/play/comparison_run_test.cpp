// SPDX-License-Identifier: MIT
//
// Catches conclusions from copies of one leg, fixtures with the same seed, and forfeits of both
// teams that count as a win, and parameters that are taken for the name of a file.
#include "tournaments/play/comparison_run.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

ComparedLeg leg_of(int one, int other, const std::string& trajectory) {
  ComparedLeg leg;
  leg.score = {one, other};
  leg.trajectory = trajectory;
  return leg;
}

// Counts fixtures that the first team wins; `different` of them have legs of their own.
PairComparison won(int fixtures, int different) {
  ComparisonRun run;
  PairComparison pair;
  for (int i = 0; i < fixtures && !is_over(pair, run); ++i) {
    const std::string name = std::to_string(i % different);
    count_fixture(pair, {leg_of(3, 1, name + "a"), leg_of(2, 0, name + "b")}, run);
  }
  return pair;
}

TEST(ComparisonRun, ConcludesNothingFromCopies) {
  const PairComparison pair = won(100, 3);
  EXPECT_TRUE(pair.is_of_copies);
  EXPECT_EQ(pair.verdict, ComparisonVerdict::undecided);
  EXPECT_EQ(pair.fixtures.size(), 20u);  // and does not play on for nothing
  EXPECT_EQ(pair.distinct_legs(), 6);
}

TEST(ComparisonRun, ConcludesFromDifferentLegs) {
  const PairComparison pair = won(100, 100);
  EXPECT_EQ(pair.verdict, ComparisonVerdict::first);
  EXPECT_LT(pair.fixtures.size(), 20u);
  EXPECT_EQ(pair.distinct_legs(), pair.legs());
}

TEST(ComparisonRun, PlaysEveryFixtureOfATable) {
  ComparisonRun run;
  run.plays_all = true;
  run.max_fixtures = 30;
  PairComparison pair;
  for (int i = 0; i < 30; ++i) {
    EXPECT_FALSE(is_over(pair, run)) << i;
    const std::string name = std::to_string(i);
    count_fixture(pair, {leg_of(3, 1, name + "a"), leg_of(2, 0, name + "b")}, run);
  }
  EXPECT_TRUE(is_over(pair, run));
  EXPECT_EQ(pair.verdict, ComparisonVerdict::first);
}

TEST(ComparisonRun, TakesADoubleForfeitForNobodysWin) {
  ComparisonRun run;
  PairComparison pair;
  ComparedLeg both = leg_of(0, 0, "a");
  both.both_lose = true;
  count_fixture(pair, {both, both}, run);
  EXPECT_EQ(pair.scores.count(ScoreSequence::most_points / 2), 1);
}

TEST(ComparisonRun, ReadsTheParametersOfATeam) {
  const ComparedTeam one = compared_team("./a:b.so:wait=0.45:speed=2");
  EXPECT_EQ(one.team, "./a:b.so");
  EXPECT_EQ(one.parameters, (std::vector<std::string>{"wait=0.45", "speed=2"}));
  EXPECT_EQ(compared_team("chaser").team, "chaser");
  EXPECT_EQ(compared_team("a=b.so").team, "a=b.so");
  EXPECT_TRUE(compared_team("a=b.so").parameters.empty());
  EXPECT_EQ(compared_team("a:=2").team, "a:=2");
}

TEST(ComparisonRun, GivesEachFixtureASeedOfItsOwn) {
  ComparisonRun run;
  std::set<std::uint64_t> seeds;
  for (int other = 1; other < 4; ++other) {
    for (int fixture = 0; fixture < 50; ++fixture)
      seeds.insert(comparison_seed(run, {0, other}, fixture));
  }
  EXPECT_EQ(seeds.size(), 150u);
}

}  // namespace
}  // namespace mirocup::league
