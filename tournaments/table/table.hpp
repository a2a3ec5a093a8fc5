// SPDX-License-Identifier: MIT
//
// The league table: a pure function of the results. Teams are ordered by the stage that they
// reached in the knockout, if there is one, then by points, then by the tie-breaks in their
// configured order. Each row names the rule that separates it from the row below. ../README.md has
// all rules.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// The result of one leg, as far as tables need it.
struct LegResult {
  int home = 0;  // index of the team
  int away = 0;  // -1 (no_team): a bye, which is won without goals
  int home_goals = 0;
  int away_goals = 0;
  bool both_lose = false;  // a double forfeit
  int home_penalties = 0;  // penalties given against the home team
  int away_penalties = 0;
  bool home_entry_still_plays = true;  // false: the home team has replaced the entry that played
  bool away_entry_still_plays = true;
  int home_entry = 0;  // the number of the entry that played; 0: not known
  int away_entry = 0;

  // Returns how many goals a team is ahead; negative if the team is behind.
  int difference(int team) const {
    return team == home ? home_goals - away_goals : away_goals - home_goals;
  }
};

enum class TieBreak {
  goal_difference,
  goals,
  head_to_head_points,
  head_to_head_goal_difference,
  penalties,
  lots,
  wins,
  opponents_points,  // sum over the team's legs of the opponent's points in the table
};

// The points for a win, a draw or a loss are within ±max_points, so that sums always fit into 64
// bits.
inline constexpr int max_points = 1'000'000;

struct Points {
  int win = 3;
  int draw = 1;
  int loss = 0;
};

// The usual order of tie-breaks; ../README.md explains each rule.
inline constexpr std::array<TieBreak, 6> default_tie_breaks{
    TieBreak::goal_difference,     TieBreak::goals,
    TieBreak::head_to_head_points, TieBreak::head_to_head_goal_difference,
    TieBreak::penalties,           TieBreak::lots};

struct TableRow {
  int team = 0;
  int rank = 0;  // from 1; 0: the team is absent, see TableRules::by_points_per_leg
  int played = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  std::int64_t goals_for = 0;
  std::int64_t goals_against = 0;
  std::int64_t points = 0;
  std::int64_t penalties = 0;  // given against the team
  std::string separated_by;    // the rule that puts this row above the next; "" for the last row

  std::int64_t difference() const { return goals_for - goals_against; }
};

// A tie-break does not depend on how many legs a team has played. Sums over legs are compared as
// means, and for goal difference and goals a bye counts as an average won leg. Head-to-head counts
// only if all pairs of the level teams have met equally often. An opponent that has left, or a bye,
// counts as an opponent with as many points as the team of the row. Teams that have left come last.
struct TableRules {
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};
  std::uint64_t seed = 1;  // the seed of the lots
  // True for a ladder or a nightly league, in which teams play different numbers of legs. A team
  // without a leg that counts is then absent: it has no rank and comes after all other teams.
  bool by_points_per_leg = false;
  // True for groups of different sizes: a team of the smaller group plays fewer legs, so the mean
  // of its points is compared, as its goals are.
  bool has_uneven_groups = false;
  // By team, whole numbers: they rank the teams before points do. Empty: points rank the teams.
  std::vector<double> strengths = {};
  std::vector<bool> has_left = {};  // true for each team that has left; empty: no team has left
};

// Returns the rows of these teams, best first. Only byes and results between two of these teams
// count. `stage_reached` is indexed by team and grows with the progress in a knockout; it is empty
// if there is no knockout.
std::vector<TableRow> make_table(const std::vector<int>& teams,
                                 const std::vector<LegResult>& results, const TableRules& rules,
                                 const std::vector<int>& stage_reached = {});

// Returns the list of the teams 0 to teams-1.
std::vector<int> all_teams(int teams);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 8> enum_names<league::TieBreak>{
    "goal_difference",
    "goals",
    "head_to_head_points",
    "head_to_head_goal_difference",
    "penalties",
    "lots",
    "wins",
    "opponents_points"};
static_assert(to_string(league::TieBreak::opponents_points) == "opponents_points");

}  // namespace mirocup
