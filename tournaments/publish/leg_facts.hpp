// SPDX-License-Identifier: MIT
//
// Facts of a leg for pages: goals with their times and scorers, fouls, the score of a shoot-out.
// They come from the match record, because the journal has only the result.
#pragma once

#include "tournaments/league/folder.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::league {

struct GoalFact {
  double at = 0.0;       // s since the leg began
  bool is_home = false;  // true: the goal counts for the home team
  int scorer = -1;       // the robot that scored; -1: not known, or an own goal
  bool is_own_goal = false;
};

struct LegFacts {
  double length = 0.0;  // s
  std::vector<GoalFact> goals;
  HomeAway fouls;                     // decisions against each team
  std::optional<HomeAway> shoot_out;  // number of scored attempts
};

// The facts by the path of the record inside the league folder.
using FactsOfLegs = std::map<std::string, LegFacts>;

// Reads the facts of all played legs. `known` are the facts of earlier calls, which are not read
// again, since records do not change. A record that cannot be read has no facts.
FactsOfLegs read_facts(system::Files& files, const Folder& folder, const LeagueState& state,
                       FactsOfLegs known = {});

// Returns the facts of a record's text; nothing if the text is not a record. `is_home_blue`: true
// if the home team was blue.
std::optional<LegFacts> facts_of(const std::string& bytes, bool is_home_blue);

}  // namespace mirocup::league
