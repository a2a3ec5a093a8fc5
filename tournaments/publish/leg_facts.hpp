// SPDX-License-Identifier: MIT
//
// Facts of a leg for pages: goals with their times and scorers, fouls, the score of a shoot-out,
// football statistics. They come from the files of the leg, because the journal has only the
// result.
#pragma once

#include "record/clock_words.hpp"
#include "record/statistics/leg_report.hpp"
#include "tournaments/league/folder.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::league {

// A leg of the league: the id of its fixture and its number, from 1.
using LegName = std::pair<std::string, int>;

// Returns "r3-f1 leg 2".
std::string name_in_words(const LegName& leg);

struct GoalFact {
  double at = 0.0;  // s since the leg began
  record::ClockTime when = {};
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

// What the files of a leg tell: its record, and the statistics that site/ keeps (site_file.hpp).
// The program counts a leg once, when it makes the leg's replay page.
struct KnownLeg {
  std::optional<LegFacts> facts;                // empty: the record cannot be read
  std::optional<statistics::LegReport> report;  // empty: none is kept, or it cannot be read
};

// By the path of the record inside the league folder.
using KnownLegs = std::map<std::string, KnownLeg>;

// Reads what is not yet known of the played legs of a state. Records do not change.
void read_legs(system::Files& files, const Folder& folder, const LeagueState& state,
               KnownLegs& known);

// Reads the statistics that are kept for a record of a leg.
std::optional<statistics::LegReport> kept_report(system::Files& files, const Folder& folder,
                                                 const LegName& leg, const std::string& record);

// Returns the facts of a record's text; nothing if the text is not a record. `is_home_blue`: true
// if the home team was blue.
std::optional<LegFacts> facts_of(const std::string& bytes, bool is_home_blue);

}  // namespace mirocup::league
