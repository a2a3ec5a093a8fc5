// SPDX-License-Identifier: MIT
//
// The league table: a pure function of the results. Teams are ordered by the stage that they
// reached in a knockout, if there is one, then by points, then by the tie-breaks in their
// configured order. Each row names the criterion that separates it from the row below.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// The result of one leg, with the fields that tables need.
struct LegResult {
  int home = 0;  // index of the team
  int away = 0;  // -1: a bye, which counts as a win without goals
  int home_goals = 0;
  int away_goals = 0;
  bool both_lose = false;  // a double forfeit
  int home_penalties = 0;  // penalties given against the team
  int away_penalties = 0;
  bool counts_for_home = true;  // false: the entry that played has been replaced since
  bool counts_for_away = true;

  // Returns the number of goals by which the team is ahead; negative if it is behind.
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
  opponents_points,  // sum of the opponents' points, each once for each leg against it
};

struct Points {
  int win = 3;
  int draw = 1;
  int loss = 0;
};

// The order that FIRA-like leagues use: see README.md.
inline constexpr std::array<TieBreak, 6> default_tie_breaks{
    TieBreak::goal_difference,     TieBreak::goals,
    TieBreak::head_to_head_points, TieBreak::head_to_head_goal_difference,
    TieBreak::penalties,           TieBreak::lots};

struct TableRow {
  int team = 0;
  int played = 0;
  int won = 0;
  int drawn = 0;
  int lost = 0;
  int goals_for = 0;
  int goals_against = 0;
  int points = 0;
  int penalties = 0;         // given against the team
  std::string separated_by;  // criterion that put it above the next row; "" for the last

  int difference() const { return goals_for - goals_against; }
};

struct TableRules {
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};
  std::uint64_t seed = 1;          // for drawing lots
  bool by_points_per_leg = false;  // for formats whose teams play different numbers of legs
};

// Returns a row for each of these teams, best first, computed from the results between them.
// `stage_reached` is how far each team came in a knockout (more is better), indexed by team; it is
// empty if there is no knockout.
std::vector<TableRow> make_table(const std::vector<int>& teams,
                                 const std::vector<LegResult>& results, const TableRules& rules,
                                 const std::vector<int>& stage_reached = {});

// Returns the list of the teams 0 .. teams-1.
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

}  // namespace mirocup
