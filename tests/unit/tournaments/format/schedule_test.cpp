// SPDX-License-Identifier: MIT
//
// Catches a pair that meets twice or never, a team that plays twice in a round, a team that is
// always at home.
#include "tournaments/format/schedule.hpp"

#include "tests/unit/tournaments/sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace mirocup::league {
namespace {

class RoundRobin : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, RoundRobin, all_sizes());

TEST_P(RoundRobin, BringsEveryPairTogetherOnceInRoundsWithFairHomes) {
  const int n = GetParam();
  std::set<std::set<int>> pairs;
  std::set<std::string> ids;
  std::map<int, std::set<int>> rounds;
  std::map<int, int> balance;  // fixtures at home, minus those away
  for (const Fixture& f : round_robin(n)) {
    EXPECT_NE(f.home, f.away);
    EXPECT_TRUE(pairs.insert({f.home, f.away}).second) << f.id();
    EXPECT_TRUE(ids.insert(f.id()).second);
    EXPECT_TRUE(rounds[f.round].insert(f.home).second) << "a team plays at most once in a round";
    EXPECT_TRUE(rounds[f.round].insert(f.away).second);
    ++balance[f.home];
    --balance[f.away];
  }
  EXPECT_EQ(static_cast<int>(pairs.size()), n * (n - 1) / 2);
  EXPECT_EQ(static_cast<int>(rounds.size()), n % 2 == 0 ? n - 1 : n);
  for (const auto& [team, difference] : balance) EXPECT_LE(std::abs(difference), 1) << team;
}

TEST(FixtureSeed, DependsOnTheLeagueAndWhoPlays) {
  const Fixture f{1, 1, 0, 1};
  EXPECT_EQ(fixture_seed(5, f), fixture_seed(5, f));
  EXPECT_NE(fixture_seed(5, f), fixture_seed(6, f));
  EXPECT_NE(fixture_seed(5, f), fixture_seed(5, Fixture{1, 1, 1, 0}));
  EXPECT_NE(fixture_seed(5, f), fixture_seed(5, Fixture{2, 1, 0, 1}));
  EXPECT_LT(fixture_seed(5, f), 1ULL << 53);
}

// Catches a pair that never meets in the nights, a team that plays twice as often as another, and
// two fixtures of a night with one number.
TEST(Night, LetsEveryPairMeetEquallyOften) {
  const std::vector<int> teams{1, 3, 4, 6, 7, 9};
  for (const int opponents : {0, 1, 2, 5, 50}) {
    std::map<std::pair<int, int>, int> met;
    const int nights = 5;  // a multiple of all cycles
    for (int night = 1; night <= nights; ++night) {
      std::map<int, int> played;
      std::set<std::string> ids;
      for (const Fixture& f : night_fixtures(night, teams, opponents)) {
        EXPECT_TRUE(ids.insert(f.id()).second);
        EXPECT_EQ(f.round, night);
        ++played[f.home];
        ++played[f.away];
        ++met[std::minmax(f.home, f.away)];
      }
      for (const int team : teams)
        EXPECT_EQ(played[team], opponents == 0 ? 5 : std::min(opponents, 5)) << opponents;
    }
    EXPECT_EQ(met.size(), 15u) << opponents;
    for (const auto& [pair, count] : met) EXPECT_EQ(count, met.begin()->second) << opponents;
  }
  EXPECT_TRUE(night_fixtures(1, {4}, 0).empty());
}

}  // namespace
}  // namespace mirocup::league
