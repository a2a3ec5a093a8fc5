// SPDX-License-Identifier: MIT
//
// The facts of a leg on pages besides its result: goals with their times and scorers, fouls, the
// score of a shoot-out. They are read from the match records, because the journal lacks them.
#pragma once

#include "tournaments/league/folder.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

struct GoalFact {
  double at = 0.0;       // s since the leg began
  bool is_home = false;  // true: it counts for the home team
  int scorer = -1;       // the robot of that team; -1: not known, or an own goal
  bool is_own_goal = false;
};

struct LegFacts {
  double length = 0.0;  // s
  std::vector<GoalFact> goals;
  HomeAway fouls;                     // decisions against the team
  std::optional<HomeAway> shoot_out;  // attempts scored
};

// By the path of the record inside the league folder.
using FactsOfLegs = std::map<std::string, LegFacts>;

// Reads the facts of all played legs. `known` are the facts that were read before, since records do
// not change. A record that cannot be read has no facts.
FactsOfLegs read_facts(system::Files& files, const Folder& folder, const LeagueState& state,
                       FactsOfLegs known = {});

// Returns the facts of a record's text; nothing if the text is not a record. `is_home_blue`: the
// home team was blue.
std::optional<LegFacts> facts_of(const std::string& bytes, bool is_home_blue);

}  // namespace mirocup::league
