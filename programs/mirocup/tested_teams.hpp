// SPDX-License-Identifier: MIT
//
// The teams that drills test, and their tries.
#pragma once

#include "programs/mirocup/drill_report.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::app {

struct TestedTeam {
  std::string text;        // as on the command line: a team, or NAME=TEAM
  std::string name;        // in reports and in the names of files
  std::string fault = {};  // why it can never play; "": it can play
};

// Splits NAME=TEAM into the name and the team. The name of TEAM alone is that of its file.
std::pair<std::string, std::string> split_team(const std::string& text);

// The name of a team for which the command line has no other: that of its file, or, if it has one,
// the name that it gives itself.
enum class NamedAfter { file, itself };

// Starts the team once, unless it is a house team. Errors: Errc::input if the text names no team,
// or a team on the network.
Result<TestedTeam> tested_team(const std::string& text, NamedAfter named_after);

// An entry of a team of a league.
struct LeagueEntry {
  std::string team;
  std::string path;  // of its library; "": the team has no entry
};

// Returns the present entries of a league, in the order of its teams. If the league has a deadline
// for the sheet of this name, the entries are the last accepted ones that were handed in by it.
Result<std::vector<LeagueEntry>> entries_of_league(const std::string& league,
                                                   const std::string& sheet = "");

// Tries all drills with each team, and returns a report for each. A team with a fault has this
// fault in each try, and is not started. On a terminal, a line counts the tries. With a folder for
// replays, writes index.html into it, which lists the failed tries.
// `tries`: of each drill; empty: as each drill says. `drills` must outlive the reports. An error is
// a team of a drill that is not there, or one of play_drills().
Result<std::vector<DrillReport>> try_drills(const std::vector<TestedTeam>& teams,
                                            const std::vector<drills::Drill>& drills,
                                            std::optional<int> tries,
                                            const match::TeamParameters& parameters,
                                            const DrillTerms& terms);

}  // namespace mirocup::app
