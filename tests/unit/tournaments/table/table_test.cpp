// SPDX-License-Identifier: MIT
//
// Catches tie-breaks in the wrong order, head-to-head counts over the wrong teams, a forfeit that
// is a draw.
#include "tournaments/table/table.hpp"

#include "tests/unit/tournaments/leg_result.hpp"
#include "tests/unit/tournaments/sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::league {
namespace {

std::vector<int> order(const std::vector<TableRow>& rows) {
  std::vector<int> teams;
  for (const TableRow& row : rows) teams.push_back(row.team);
  return teams;
}

enum { A, B, C, D };

TEST(Table, CountsPointsAndGoals) {
  const auto rows = make_table(all_teams(2), {leg_result(A, B, 2, 1), leg_result(B, A, 3, 3)}, {});
  EXPECT_EQ(order(rows), (std::vector<int>{A, B}));
  EXPECT_EQ(rows[0].points, 4);
  EXPECT_EQ(rows[0].goals_for, 5);
  EXPECT_EQ(rows[1].points, 1);
  EXPECT_EQ(rows[0].separated_by, "points");
}

// A team that played and lost everything is ahead of one that never handed in. Catches an absent
// team with a rank, and points a leg that rank before the strength.
TEST(Table, RanksByStrengthAndLeavesOutTheAbsent) {
  TableRules rules;
  rules.by_points_per_leg = true;
  rules.strengths = {-50.0, 0.0, 60.0, -50.0};
  rules.has_left = {false, false, true, false};
  const auto rows =
      make_table(all_teams(4),
                 {leg_result(A, C, 0, 9), leg_result(D, A, 1, 0), leg_result(C, D, 1, 0)}, rules);
  EXPECT_EQ(order(rows), (std::vector<int>{D, A, C, B}));
  EXPECT_EQ(rows[0].separated_by, "points per leg") << "equal strengths";
  EXPECT_EQ(rows[1].separated_by, "withdrawn");
  EXPECT_EQ(rows[2].separated_by, "absent");
  EXPECT_EQ(rows[2].rank, 3);
  EXPECT_EQ(rows[3].rank, 0);
  rules.strengths = {-40.0, 0.0, 60.0, -50.0};
  EXPECT_EQ(
      make_table(all_teams(4), {leg_result(A, C, 0, 9), leg_result(D, A, 1, 0)}, rules)[0].team, A);
}

TEST(Table, GoesByGoalDifferenceInARing) {
  const auto rows = make_table(
      all_teams(3), {leg_result(A, B, 2, 1), leg_result(B, C, 3, 1), leg_result(C, A, 1, 0)}, {});
  EXPECT_EQ(order(rows), (std::vector<int>{B, A, C}));
  EXPECT_EQ(rows[0].separated_by, "goal_difference");
}

class EveryTable : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, EveryTable, all_sizes());

// Teams in a ring, each ahead of the next when they met: only lots can tell them apart, and they
// must not depend on who is asked first. Catches teams that are compared two by two.
TEST_P(EveryTable, DrawsLotsInARingOfEquals) {
  const int n = GetParam();
  std::vector<LegResult> results;
  for (int team = 0; team < n; ++team) results.push_back(leg_result(team, (team + 1) % n, 1, 0));
  const auto rows = make_table(all_teams(n), results, {});
  for (int i = 0; i < n; ++i) {
    EXPECT_EQ(rows[i].points, 3);
    EXPECT_EQ(rows[i].separated_by, i + 1 < n ? "lots" : "");
  }
  std::vector<int> teams = order(rows);
  std::reverse(results.begin(), results.end());
  EXPECT_EQ(order(make_table(all_teams(n), results, {})), teams);
  std::sort(teams.begin(), teams.end());
  EXPECT_EQ(teams, all_teams(n));
}

TEST_P(EveryTable, GivesNobodyAnythingForDoubleForfeits) {
  // All teams have lost by double forfeits, except one that won once.
  const int n = GetParam();
  std::vector<LegResult> results;
  for (int team = 0; team < n; ++team) {
    results.push_back(leg_result(team, (team + 1) % n, 0, 0));
    results.back().both_lose = true;
  }
  results.push_back(leg_result(0, n - 1, 0, 1));
  const auto rows = make_table(all_teams(n), results, {});
  EXPECT_EQ(rows[0].team, n - 1);
  EXPECT_EQ(rows[0].separated_by, "points");
  EXPECT_EQ(rows[n - 1].team, 0);
  for (int i = 1; i < n; ++i) EXPECT_EQ(rows[i].points, 0);
  EXPECT_EQ(rows[0].lost, 2);
}

TEST(Table, GoesByGoalsThenByTheirOwnMeeting) {
  // A and B are level in points, difference and goals; B won when they met.
  const std::vector<LegResult> results{leg_result(B, A, 1, 0), leg_result(A, C, 2, 1),
                                       leg_result(C, B, 1, 0), leg_result(A, C, 1, 1),
                                       leg_result(B, C, 2, 2)};
  const auto rows = make_table(all_teams(3), results, {});
  const auto at = [&](int team) {
    return *std::find_if(rows.begin(), rows.end(),
                         [team](const TableRow& r) { return r.team == team; });
  };
  ASSERT_EQ(at(A).points, at(B).points);
  ASSERT_EQ(at(A).difference(), at(B).difference());
  ASSERT_EQ(at(A).goals_for, at(B).goals_for);
  const auto ranks = order(rows);
  EXPECT_LT(std::find(ranks.begin(), ranks.end(), B), std::find(ranks.begin(), ranks.end(), A));
}

TEST(Table, TakesHeadToHeadAnewAmongThoseWhoAreLeft) {
  // Among A, B, C the mini-table puts A first and leaves B and C level in its points and
  // difference; between the two alone B is ahead.
  TableRules with_head_to_head;
  with_head_to_head.tie_breaks = {TieBreak::head_to_head_points, TieBreak::lots};
  const std::vector<LegResult> results{leg_result(A, B, 1, 0), leg_result(A, C, 1, 0),
                                       leg_result(B, C, 1, 0), leg_result(C, D, 1, 0),
                                       leg_result(B, D, 0, 1), leg_result(D, A, 1, 0)};
  const auto ranks = order(make_table(all_teams(4), results, with_head_to_head));
  EXPECT_LT(std::find(ranks.begin(), ranks.end(), B), std::find(ranks.begin(), ranks.end(), C));
}

TEST(Table, PrefersFewerPenaltiesThenDrawsLots) {
  LegResult r = leg_result(A, B, 1, 1);
  r.home_penalties = 2;
  r.away_penalties = 1;
  auto rows = make_table(all_teams(2), {r}, {});
  EXPECT_EQ(order(rows), (std::vector<int>{B, A}));
  EXPECT_EQ(rows[0].separated_by, "penalties");

  std::vector<int> first_places(2);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    TableRules rules;
    rules.seed = seed;
    rows = make_table(all_teams(2), {leg_result(A, B, 1, 1)}, rules);
    EXPECT_EQ(rows[0].separated_by, "lots");
    ++first_places[rows[0].team];
    EXPECT_EQ(order(rows), order(make_table(all_teams(2), {leg_result(A, B, 1, 1)}, rules)));
  }
  EXPECT_GT(first_places[0], 8);
  EXPECT_GT(first_places[1], 8);
}

TEST(Table, DoesNotDependOnTheOrderOfTheResults) {
  std::vector<LegResult> results{leg_result(A, B, 2, 1), leg_result(B, C, 3, 1),
                                 leg_result(C, A, 1, 0), leg_result(D, A, 0, 0)};
  const auto before = order(make_table(all_teams(4), results, {}));
  std::reverse(results.begin(), results.end());
  EXPECT_EQ(order(make_table(all_teams(4), results, {})), before);
}

TEST(Table, PutsHowFarATeamCameBeforePoints) {
  const auto rows = make_table(
      all_teams(3), {leg_result(A, B, 9, 0), leg_result(A, C, 9, 0), leg_result(C, B, 1, 0)}, {},
      {0, 1, 1});
  EXPECT_EQ(order(rows), (std::vector<int>{C, B, A}));
  EXPECT_EQ(rows[0].separated_by, "points");
  EXPECT_EQ(rows[1].separated_by, "knockout");
}

TEST(Table, CountsOnlyTheTeamsThatAreAsked) {
  const auto rows = make_table(
      {C, A}, {leg_result(A, B, 0, 9), leg_result(A, C, 1, 0), leg_result(C, B, 9, 0)}, {});
  EXPECT_EQ(order(rows), (std::vector<int>{A, C}));
  EXPECT_EQ(rows[0].played, 1);
}

TEST(Table, GivesAByeAWinWithoutGoals) {
  const auto rows = make_table(all_teams(2), {leg_result(B, -1, 0, 0)}, {});
  EXPECT_EQ(rows[0].team, B);
  EXPECT_EQ(rows[0].points, 3);
  EXPECT_EQ(rows[0].goals_for, 0);
  EXPECT_EQ(rows[1].played, 0);
}

TEST(Table, PrefersWhoMetStrongerOpponents) {
  // A and B won once each with the same goals; A's opponent has won elsewhere.
  TableRules rules;
  rules.tie_breaks = {TieBreak::opponents_points, TieBreak::lots};
  enum { E = 4, F };
  const auto rows = make_table(all_teams(6),
                               {leg_result(A, C, 1, 0), leg_result(B, D, 1, 0),
                                leg_result(C, E, 5, 0), leg_result(F, E, 1, 0)},
                               rules);
  const auto ranks = order(rows);
  EXPECT_LT(std::find(ranks.begin(), ranks.end(), A), std::find(ranks.begin(), ranks.end(), B));
}

TEST(Table, ComparesUnlikeNumbersOfLegsByTheirMean) {
  TableRules rules;
  rules.by_points_per_leg = true;
  LegResult old = leg_result(A, B, 0, 1);
  old.home_entry_still_plays = false;  // A has another entry since
  const auto rows = make_table(
      all_teams(3), {old, leg_result(A, C, 1, 0), leg_result(B, C, 1, 0), leg_result(C, B, 1, 0)},
      rules);
  EXPECT_EQ(order(rows), (std::vector<int>{A, B, C}));
  EXPECT_EQ(rows[0].played, 1);
  EXPECT_EQ(rows[1].played, 3) << "B keeps what it won against the old entry";
}

// A of a group of two has one win of one leg, B of a group of three one win of two: B was above A,
// whose second leg does not exist, by the goals of that leg.
TEST(Table, ComparesTheMeansOfGroupsOfDifferentSizes) {
  constexpr int E = 4;
  TableRules rules;
  rules.has_uneven_groups = true;
  const std::vector<LegResult> legs{leg_result(A, C, 1, 0), leg_result(B, D, 1, 0),
                                    leg_result(B, E, 0, 0), leg_result(D, E, 0, 0)};
  EXPECT_EQ(order(make_table(all_teams(5), legs, rules)), (std::vector<int>{A, B, E, D, C}));
  rules.has_uneven_groups = false;
  EXPECT_EQ(order(make_table(all_teams(5), legs, rules)).front(), B) << "by the sum";
}

// Catches sums of points and goals that do not fit into 32 bits: the winner of all stood last.
TEST(Table, AddsTheLargestPointsAndGoalsOfManyLegs) {
  TableRules rules;
  rules.points.win = max_points;
  constexpr int legs = 3000;
  const auto rows =
      make_table(all_teams(2), std::vector<LegResult>(legs, leg_result(A, B, 1'000'000, 0)), rules);
  EXPECT_EQ(order(rows), (std::vector<int>{A, B}));
  EXPECT_EQ(rows[0].points, 3'000'000'000);
  EXPECT_EQ(rows[1].difference(), -3'000'000'000);
}

// As an opponent, a bye and a team that has left have as many points as the team itself: they
// neither favour it nor punish it.
TEST(Table, CountsAByeAndATeamThatLeftAsAnOpponentLikeItself) {
  // 0, 1 and 2 have 6 points each: by a bye, against 3, which left, and against 4.
  std::vector<LegResult> results{leg_result(0, -1, 0, 0), leg_result(0, -1, 0, 0)};
  for (int leg = 0; leg < 2; ++leg) {
    results.push_back(leg_result(1, 3, 1, 0));
    results.push_back(leg_result(2, 4, 1, 0));
    results.push_back(leg_result(5, 4, 0, 1));
  }
  TableRules rules;
  rules.tie_breaks = {TieBreak::opponents_points, TieBreak::head_to_head_points};
  rules.has_left = {false, false, false, true, false, false};
  EXPECT_EQ(order(make_table(all_teams(6), results, rules)), (std::vector<int>{0, 1, 2, 4, 5, 3}))
      << "level, and 3 comes last";
}

// Sums favour whoever has played more legs with goals.
TEST(Table, ComparesGoalsOfUnlikeNumbersOfLegsByTheirMean) {
  std::vector<LegResult> results{leg_result(0, -1, 0, 0), leg_result(0, 2, 2, 0),
                                 leg_result(1, 2, 2, 0), leg_result(1, 3, 1, 0)};
  EXPECT_EQ(make_table(all_teams(4), results, {})[0].team, 0) << "2 a leg against 1.5";
}

// A bye gives points without goals: a team of as many points has won a leg more by goals. Catches
// the team of a bye that nearly always comes last of the level teams.
TEST(Table, CountsAByeAsAnAverageWonLegInTieBreaksOfGoals) {
  const std::vector<LegResult> results{leg_result(A, -1, 0, 0), leg_result(B, D, 1, 0),
                                       leg_result(C, A, 1, 0), leg_result(C, B, 1, 0),
                                       leg_result(C, D, 5, 0)};
  // A won leg is won by two goals on average. A leg: A is 0.5 ahead and B 0.
  for (const TieBreak rule : {TieBreak::goal_difference, TieBreak::goals}) {
    TableRules rules;
    rules.tie_breaks = {rule};
    EXPECT_EQ(order(make_table(all_teams(4), results, rules)), (std::vector<int>{C, A, B, D}));
  }
}

// Head-to-head says nothing of teams of which some have not met.
TEST(Table, LeavesOutHeadToHeadOfTeamsThatHaveNotMet) {
  const std::vector<LegResult> results{leg_result(0, 1, 1, 0), leg_result(1, 3, 1, 0),
                                       leg_result(2, 4, 1, 0), leg_result(0, 5, 0, 1)};
  TableRules rules;
  rules.tie_breaks = {TieBreak::head_to_head_points, TieBreak::lots};
  // 0, 1, 2 and 5 have 3 points, and 5 has beaten 0.
  const auto table = make_table(all_teams(6), results, rules);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(table[i].separated_by, "lots");
}

}  // namespace
}  // namespace mirocup::league
