// SPDX-License-Identifier: MIT
//
// What pages and exports say of each leg, in the order of the schedule, and of each team; and the
// words for what ended a leg, what a fault is and what put one team above another.
#pragma once

#include "tournaments/league/league_state.hpp"
#include "tournaments/table/rating.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct LegView {
  std::string fixture;  // its id
  std::string round;    // "Round 3", "Group 2, round 1", "Semi-final"
  int leg = 1;          // from 1
  int home = 0;
  int away = 0;
  const PlayedLeg* played = nullptr;  // null: not yet

  bool is_of(int team) const { return home == team || away == team; }
  int goals(int team) const;
  int goals_against(int team) const { return goals(team == home ? away : home); }
  // 'W', 'D' or 'L' for a team that played.
  char letter(int team) const;
};

// What a site is made of, computed once.
struct Overview {
  const LeagueState& state;
  std::vector<TableRow> table;
  std::vector<Strength> strengths;  // by team
  std::vector<LegView> legs;        // those whose teams are known
};
Overview overview(const LeagueState& state);

// "Final", "Semi-final", "Round 1" of the knockout, ...
std::string round_in_words(const LeagueState& state, const Fixture& fixture);

// "2 : 1, golden goal; awarded by ...": how it ended, who is to blame, who ruled.
std::string end_in_words(const LeagueState& state, const PlayedLeg& leg);

// A fault without its team, with words for its code.
std::string fault_in_words(const LegFault& fault);

// What put a row above the next: "goal difference, +5 to +2"; "" for the last, and
// before the two have played.
std::string reason_in_words(const TableRow& row, const TableRow* next);

}  // namespace mirocup::league
