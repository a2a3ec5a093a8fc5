// SPDX-License-Identifier: MIT
//
// The league table: a pure function of the results. Order: how far a team came in a knockout, if
// there is one; points; then the tie-breaks in their configured order. Each row says what separated
// it from the one below.
#pragma once

#include "core/base/names.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// One leg's result, as far as tables need it.
struct LegResult {
  int home = 0;  // index of the team
  int away = 0;  // -1: a bye, which is won without goals
  int home_goals = 0;
  int away_goals = 0;
  bool both_lose = false;  // a double forfeit
  int home_penalties = 0;  // penalties given against the team
  int away_penalties = 0;
  bool counts_for_home = true;  // false: an entry played that has been replaced since
  bool counts_for_away = true;

  // How many goals that team is ahead.
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
  opponents_points,  // the points of all whom the team met, once for each leg
};

struct Points {
  int win = 3;
  int draw = 1;
  int loss = 0;
};

// In the order of the FIRA-like leagues: see README.md.
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
  std::string separated_by;  // what put it above the next row; "" for the last

  int difference() const { return goals_for - goals_against; }
};

struct TableRules {
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};
  std::uint64_t seed = 1;          // of the lots
  bool by_points_per_leg = false;  // where teams play unlike numbers of legs
};

// These teams, best first, by the results between them. `came` says how far each came in a knockout
// (more is better), indexed by team; empty: there is none.
std::vector<TableRow> make_table(const std::vector<int>& teams,
                                 const std::vector<LegResult>& results, const TableRules& rules,
                                 const std::vector<int>& stage_reached = {});

// Teams 0 .. teams-1.
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
