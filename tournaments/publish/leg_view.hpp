// SPDX-License-Identifier: MIT
//
// The data that pages and exports show of each leg, in the order of the schedule, and of each team;
// and the texts for the end of a leg, for faults and for tie-breaks.
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
  const PlayedLeg* played = nullptr;  // null: not decided yet; points into the LeagueState

  bool is_of(int team) const { return home == team || away == team; }
  int goals(int team) const;
  int goals_against(int team) const { return goals(team == home ? away : home); }
  // Returns 'W', 'D' or 'L' for one of the two teams. Precondition: the leg is decided.
  char letter(int team) const;
};

// The data of a site, computed once. It refers to the league's state, which must outlive it.
struct Overview {
  const LeagueState& state;
  std::vector<TableRow> table;
  std::vector<Strength> strengths;  // by team
  std::vector<LegView> legs;        // legs whose teams are known
};
Overview overview(const LeagueState& state);

// Returns the name of the fixture's round: "Final", "Semi-final", "Group 2, round 1", ...
std::string round_in_words(const LeagueState& state, const Fixture& fixture);

// Returns how the leg ended, with the fault and the ruling if there are any: "2 : 1, golden goal;
// awarded by ...".
std::string end_in_words(const LeagueState& state, const PlayedLeg& leg);

// Returns a sentence for a fault, without its team.
std::string fault_in_words(const LegFault& fault);

// Returns the criterion that put a row above the next, with values: "goal difference, +5 to +2". ""
// for the last row, and before either team has played.
std::string reason_in_words(const TableRow& row, const TableRow* next);

}  // namespace mirocup::league
