// SPDX-License-Identifier: MIT
//
// Catches a knockout in which a bye meets a bye, the two best meet early or a losing team plays on;
// groups whose sizes differ by more than one; a Swiss tournament that pairs two teams twice or
// gives a team a second bye.
#include "core/base/random.hpp"
#include "tests/unit/tournaments/sizes.hpp"
#include "tournaments/format/groups.hpp"
#include "tournaments/format/swiss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace mirocup::league {
namespace {

std::vector<TeamSource> seeds(int teams) {
  std::vector<TeamSource> sources;
  for (int i = 0; i < teams; ++i) sources.push_back({TeamSource::Kind::team, i, 0});
  return sources;
}

class Formats : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, Formats, all_sizes());

// Plays a knockout in which `winner` chooses the winners; returns the outcomes of the ties.
template <class Winner>
std::vector<TieOutcome> play(std::vector<Fixture>& ties, Winner winner) {
  std::vector<TieOutcome> outcomes;
  const auto taken = [&outcomes](const TeamSource& source) {
    if (source.kind == TeamSource::Kind::team) return source.index;
    const TieOutcome& before = outcomes.at(source.index);  // throws if it comes later
    return source.kind == TeamSource::Kind::winner ? before.winner : before.loser;
  };
  for (Fixture& tie : ties) {
    tie.home = taken(tie.home_source);
    tie.away = taken(tie.away_source);
    const int won = winner(tie.home, tie.away);
    outcomes.push_back({won, won == tie.home ? tie.away : tie.home});
  }
  return outcomes;
}

TEST_P(Formats, KnockoutNeedsOneTieLessThanTeams) {
  const int n = GetParam();
  auto ties = knockout(seeds(n), {.third_place = false});
  ASSERT_EQ(static_cast<int>(ties.size()), n - 1);
  Random random(n);
  const auto outcomes = play(ties, [&](int a, int b) { return random.coin() ? a : b; });
  std::set<int> out;
  for (const TieOutcome& o : outcomes) {
    EXPECT_GE(o.winner, 0);
    EXPECT_GE(o.loser, 0) << "a bye is no tie";
    EXPECT_EQ(out.count(o.winner), 0u) << "who lost plays no more";
    EXPECT_TRUE(out.insert(o.loser).second);
  }
  EXPECT_EQ(static_cast<int>(out.size()), n - 1);
  std::set<std::string> ids;
  for (const Fixture& tie : ties) EXPECT_TRUE(ids.insert(tie.id()).second) << tie.id();
}

TEST_P(Formats, KnockoutBringsTheBestTogetherInTheFinalAndGivesThemTheByes) {
  const int n = GetParam();
  auto ties = knockout(seeds(n), {.third_place = false});
  play(ties, [](int a, int b) { return std::min(a, b); });
  EXPECT_EQ(std::min(ties.back().home, ties.back().away), 0);
  EXPECT_EQ(std::max(ties.back().home, ties.back().away), 1);
  // In every round the best remaining team plays the worst, the second best the second worst, etc.
  std::map<int, std::vector<Fixture>> rounds;
  for (const Fixture& tie : ties) rounds[tie.round].push_back(tie);
  int size = 1;
  while (size < n) size *= 2;
  EXPECT_EQ(static_cast<int>(rounds[1].size()), n - size / 2);
  std::set<int> in_first_round;
  for (const Fixture& tie : rounds[1]) {
    EXPECT_EQ(tie.home + tie.away, size - 1);
    in_first_round.insert({tie.home, tie.away});
  }
  for (int bye = 0; bye < size - n; ++bye) EXPECT_EQ(in_first_round.count(bye), 0u) << bye;
}

TEST_P(Formats, KnockoutPlaysForTheThirdPlace) {
  const int n = GetParam();
  auto ties = knockout(seeds(n), {});
  play(ties, [](int a, int b) { return std::min(a, b); });
  if (n < 4) {
    EXPECT_EQ(static_cast<int>(ties.size()), n - 1) << "there is but one semi-final";
    return;
  }
  EXPECT_EQ(static_cast<int>(ties.size()), n);
  EXPECT_EQ(std::min(ties.back().home, ties.back().away), 2);
  EXPECT_EQ(std::max(ties.back().home, ties.back().away), 3);
  EXPECT_EQ(ties.back().id(), "k" + std::to_string(ties.back().round) + "-f2");
}

TEST_P(Formats, GroupsAreAlikeAndTheirFirstGoOn) {
  const int n = GetParam();
  for (int groups = 1; groups <= n / 2; ++groups) {
    const auto dealt = deal_groups(n, groups);
    std::set<int> all;
    std::size_t least = n;
    std::size_t most = 0;
    for (const auto& group : dealt) {
      least = std::min(least, group.size());
      most = std::max(most, group.size());
      all.insert(group.begin(), group.end());
    }
    EXPECT_LE(most - least, 1u);
    EXPECT_EQ(static_cast<int>(all.size()), n);

    GroupsOptions options;
    options.groups = groups;
    const auto fixtures = groups_then_knockout(n, options);
    std::set<std::string> ids;
    std::set<std::set<int>> pairs;
    std::set<std::pair<int, int>> places;
    for (std::size_t i = 0; i < fixtures.size(); ++i) {
      const Fixture& f = fixtures[i];
      EXPECT_TRUE(ids.insert(f.id()).second) << f.id();
      if (f.part == Part::group) {
        EXPECT_TRUE(pairs.insert({f.home, f.away}).second);
        continue;
      }
      for (const TeamSource& source : {f.home_source, f.away_source}) {
        if (source.kind == TeamSource::Kind::place) {
          EXPECT_TRUE(places.insert({source.index, source.place}).second);
        } else {
          EXPECT_LT(source.index, static_cast<int>(i)) << "follows from a later tie";
          EXPECT_EQ(fixtures[source.index].part, Part::knockout);
        }
      }
      const bool both = f.home_source.kind == TeamSource::Kind::place &&
                        f.away_source.kind == TeamSource::Kind::place;
      if (both && groups > 1) {
        EXPECT_NE(f.home_source.index, f.away_source.index) << f.id();
      }
    }
    EXPECT_EQ(static_cast<int>(places.size()), 2 * groups);
  }
}

// Catches a bracket in which group mates meet earlier than they must, and one that takes a bye from
// a winner of a group.
TEST(Groups, KeepTheTeamsOfAGroupApart) {
  for (int groups = 2; groups <= 8; ++groups) {
    for (int qualifiers = 2; qualifiers <= 4 && groups * qualifiers <= 32; ++qualifiers) {
      const auto fixtures = groups_then_knockout(groups * (qualifiers + 1),
                                                 {.groups = groups, .qualifiers = qualifiers});
      int rounds = 0;
      int earliest = 100;
      int worst_bye = 0;  // the place in its group of a team that enters later
      int best_tie = qualifiers;
      std::vector<std::multiset<int>> of_tie(fixtures.size());  // the groups that can play a tie
      for (std::size_t i = 0; i < fixtures.size(); ++i) {
        const Fixture& f = fixtures[i];
        if (f.part != Part::knockout || f.is_for_third_place()) continue;
        rounds = std::max(rounds, f.round);
        for (const TeamSource& source : {f.home_source, f.away_source}) {
          std::multiset<int> side{source.index};
          if (source.kind == TeamSource::Kind::winner) {
            side = of_tie[source.index];
          } else if (f.round > 1) {
            worst_bye = std::max(worst_bye, source.place);
          } else {
            best_tie = std::min(best_tie, source.place);
          }
          for (const int group : side) {
            if (of_tie[i].contains(group)) earliest = std::min(earliest, f.round);
          }
          of_tie[i].merge(side);
        }
      }
      const int halvings = qualifiers > 2 ? 2 : 1;
      EXPECT_GE(earliest, rounds - halvings + 1) << groups << " groups, " << qualifiers;
      EXPECT_LE(worst_bye, best_tie) << groups << " groups, " << qualifiers;
    }
  }
}

TEST_P(Formats, SwissPairsNobodyTwiceAndGivesOneByeAtMost) {
  const int n = GetParam();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const int rounds = std::min(usual_swiss_rounds(n) + 2, max_swiss_rounds(n));
    Random random(seed);
    std::vector<int> points(n, 0);
    std::vector<Fixture> before;
    std::set<std::set<int>> pairs;
    for (int round = 1; round <= rounds; ++round) {
      std::vector<SwissStanding> standings;
      for (int team = 0; team < n; ++team) standings.push_back({team, points[team]});
      std::stable_sort(standings.begin(), standings.end(),
                       [](const auto& a, const auto& b) { return a.points > b.points; });
      const auto fixtures = swiss_round(standings, before, round, rounds);
      std::set<int> play;
      for (const Fixture& f : fixtures) {
        EXPECT_TRUE(pairs.insert({f.home, f.away}).second) << f.id() << " seed " << seed;
        EXPECT_TRUE(play.insert(f.home).second);
        if (f.away != no_team) {
          EXPECT_TRUE(play.insert(f.away).second);
        }
        points[f.away == no_team || random.coin() ? f.home : f.away] += 3;
      }
      ASSERT_EQ(static_cast<int>(play.size()), n) << "round " << round << " seed " << seed;
      before.insert(before.end(), fixtures.begin(), fixtures.end());
    }
  }
}

TEST(Swiss, BringsLikeTogetherAndGivesTheLowestTheBye) {
  const auto fixtures = swiss_round({{4, 6}, {2, 6}, {0, 3}, {3, 0}, {1, 0}}, {}, 1, 3);
  ASSERT_EQ(fixtures.size(), 3u);
  EXPECT_EQ((std::set<int>{fixtures[0].home, fixtures[0].away}), (std::set<int>{4, 2}));
  EXPECT_EQ((std::set<int>{fixtures[1].home, fixtures[1].away}), (std::set<int>{0, 3}));
  EXPECT_EQ(fixtures[2].home, 1);
  EXPECT_EQ(fixtures[2].away, no_team);
}

TEST_P(Formats, RoundRobinRepeatsItselfWithHomesSwapped) {
  const int n = GetParam();
  for (const int legs : {1, 2, 3, 4}) {
    std::map<std::set<int>, int> met;
    std::map<int, int> blue;
    std::set<std::string> ids;
    for (const Fixture& f : round_robin(n, legs)) {
      met[{f.home, f.away}] += f.legs;
      ++blue[f.home];
      if (f.legs == 2) ++blue[f.away];
      EXPECT_TRUE(ids.insert(f.id()).second);
    }
    EXPECT_EQ(static_cast<int>(met.size()), n * (n - 1) / 2);
    for (const auto& [pair, count] : met) EXPECT_EQ(count, legs);
    for (const auto& [team, count] : blue) EXPECT_LE(std::abs(2 * count - legs * (n - 1)), 1);
  }
}

TEST(Ladder, DrawsASampleOfTheOthersWithoutFavour) {
  const std::vector<int> others{0, 1, 2, 3, 4, 5, 6, 7};
  std::map<int, int> drawn;
  for (int event = 1; event <= 400; ++event) {
    std::set<int> sample;
    for (const Fixture& f : ladder_fixtures(event, 9, others, 4, 5)) {
      EXPECT_EQ(f.home, 9);
      EXPECT_TRUE(sample.insert(f.away).second);
      ++drawn[f.away];
    }
    EXPECT_EQ(sample.size(), 4u);
  }
  for (const int team : others) {
    EXPECT_GT(drawn[team], 150) << team;
    EXPECT_LT(drawn[team], 250) << team;
  }
  EXPECT_EQ(ladder_fixtures(1, 0, {1}, 4, 5).size(), 1u);
  EXPECT_TRUE(ladder_fixtures(1, 0, {}, 4, 5).empty());
}

}  // namespace
}  // namespace mirocup::league
