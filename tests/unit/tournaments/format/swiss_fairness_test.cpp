// SPDX-License-Identifier: MIT
//
// Simulates many Swiss tournaments of teams of equal strength. Catches a bye that goes to a team
// although a team with fewer points could have it, a second meeting, and tie-breaks or byes that
// favour or punish the teams that had a bye.
#include "tests/unit/tournaments/leg_result.hpp"
#include "tournaments/format/swiss.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace mirocup::league {
namespace {

#ifdef MIROCUP_SANITIZED
constexpr int tournaments = 100;
#else
constexpr int tournaments = 2000;
#endif

using Pairs = std::set<std::pair<int, int>>;

std::pair<int, int> pair_of(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

// Shares no code with the program.
bool can_be_paired(std::vector<int> teams, const Pairs& met) {
  if (teams.empty()) return true;
  const int first = teams.front();
  for (std::size_t i = 1; i < teams.size(); ++i) {
    if (met.contains(pair_of(first, teams[i]))) continue;
    std::vector<int> rest(teams.begin() + 1, teams.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i) - 1);
    if (can_be_paired(std::move(rest), met)) return true;
  }
  return false;
}

struct Simulated {
  std::vector<LegResult> results;
  std::set<int> byes;
  TableRules rules;
  int avoidable = 0;  // byes that a team with fewer points could have had
  int unpaired = 0;   // rounds
  int second = 0;     // meetings and byes
};

// Each leg is won, drawn or lost with the same probability. After each round a team leaves with
// `leaves` in a hundred.
Simulated simulate(int teams, int seed, int leaves) {
  std::mt19937 random(static_cast<unsigned>(seed * 77 + teams));
  const auto below = [&random](unsigned n) { return static_cast<int>(random() % n); };
  const int rounds = usual_swiss_rounds(teams);
  Simulated s;
  s.rules.seed = static_cast<std::uint64_t>(seed);
  s.rules.tie_breaks = {TieBreak::opponents_points, TieBreak::goal_difference, TieBreak::lots};
  s.rules.has_left.assign(teams, false);
  std::vector<Fixture> before;
  Pairs met;
  for (int round = 1; round <= rounds; ++round) {
    std::vector<SwissStanding> standings;
    for (const TableRow& row : make_table(all_teams(teams), s.results, s.rules)) {
      if (!s.rules.has_left[row.team]) standings.push_back({row.team, row.points});
    }
    const auto fixtures = swiss_round(standings, before, round, rounds);
    s.unpaired += fixtures.empty() ? 1 : 0;
    for (const Fixture& f : fixtures) {
      before.push_back(f);
      if (f.away == no_team) {
        const auto bye = std::find_if(standings.begin(), standings.end(),
                                      [&](const SwissStanding& t) { return t.team == f.home; });
        for (std::size_t low = standings.size(); standings[--low].points < bye->points;) {
          std::vector<int> others;
          for (std::size_t i = 0; i < standings.size(); ++i) {
            if (i != low) others.push_back(standings[i].team);
          }
          const bool could = !s.byes.contains(standings[low].team) && can_be_paired(others, met);
          s.avoidable += could ? 1 : 0;
        }
        s.second += s.byes.insert(f.home).second ? 0 : 1;
        s.results.insert(s.results.end(), legs_per_fixture, leg_result(f.home, no_team, 0, 0));
        continue;
      }
      for (int leg = 0; leg < legs_per_fixture; ++leg) {
        const int difference = below(3) - 1;
        s.results.push_back(leg_result(f.home, f.away, difference > 0, difference < 0));
      }
    }
    for (const Fixture& f : fixtures) {
      if (f.away != no_team) s.second += met.insert(pair_of(f.home, f.away)).second ? 0 : 1;
    }
    if (below(100) < leaves && round < rounds)
      s.rules.has_left[standings[below(static_cast<unsigned>(standings.size()))].team] = true;
  }
  return s;
}

// How often a team that had a bye stands above one that had none and has as many points.
class ByeAbove {
 public:
  void count(const Simulated& s, int teams) {
    const auto table = make_table(all_teams(teams), s.results, s.rules);
    for (std::size_t i = 0; i < table.size(); ++i) {
      for (std::size_t j = i + 1; j < table.size() && table[j].points == table[i].points; ++j) {
        const bool first = s.byes.contains(table[i].team);
        if (first == s.byes.contains(table[j].team)) continue;
        if (s.rules.has_left[table[i].team] || s.rules.has_left[table[j].team]) continue;
        ++level_;
        above_ += first ? 1 : 0;
      }
    }
  }

  void expect_between(double low, double high) const {
    if (tournaments < 2000) return;  // too few pairs to tell 42 % from 50 %
    const double share = 100.0 * above_ / level_;
    testing::Test::RecordProperty("share", std::to_string(share));
    EXPECT_GE(share, low) << level_ << " pairs";
    EXPECT_LE(share, high) << level_ << " pairs";
  }

 private:
  int level_ = 0;
  int above_ = 0;
};

class SwissOfOddSize : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, SwissOfOddSize, testing::Values(5, 7, 9, 15, 29, 39));

TEST_P(SwissOfOddSize, IsFairToWhoeverHasABye) {
  ByeAbove above;
  for (int seed = 0; seed < tournaments; ++seed) {
    const Simulated s = simulate(GetParam(), seed, 0);
    EXPECT_EQ(s.second, 0) << seed;
    EXPECT_EQ(s.unpaired, 0) << seed;
    EXPECT_EQ(s.avoidable, 0) << seed;
    above.count(s, GetParam());
  }
  above.expect_between(42.0, 58.0);
}

class SwissOfEvenSize : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, SwissOfEvenSize, testing::Values(6, 8, 10, 16, 30, 40));

TEST_P(SwissOfEvenSize, IsFairWhenTeamsLeave) {
  ByeAbove above;
  for (int seed = 0; seed < tournaments; ++seed) {
    const Simulated s = simulate(GetParam(), seed, 40);
    EXPECT_EQ(s.second, 0) << seed;
    EXPECT_EQ(s.avoidable, 0) << seed;
    EXPECT_EQ(GetParam() > 8 ? s.unpaired : 0, 0) << seed;
    above.count(s, GetParam());
  }
  above.expect_between(42.0, 58.0);
}

}  // namespace
}  // namespace mirocup::league
