// SPDX-License-Identifier: MIT
//
// Statistics for people and for tables: the output of `mirocup stats`.
#pragma once

#include "record/statistics/leg_report.hpp"
#include "system/commands.hpp"

#include <string>
#include <vector>

namespace mirocup::statistics {

// The content and the form of a report.
struct ReportOptions {
  bool goals = false;  // true: goals and lost balls; false: the numbers of each team
  std::string team;    // only legs of this team, and only goals against it; "": all teams
  bool csv = false;    // comma-separated values instead of text for people
  bool json = false;   // true: JSON, one object
};

// Adds the options of a command that prints a report; `about_team` is the help of --team.
void add_options(const system::Command& command, ReportOptions& options,
                 const std::string& about_team);

// Returns the output of `mirocup stats` about legs. The JSON has both goals and numbers.
// Errors: Errc::input if the team has no leg.
Result<std::string> report(std::vector<LegReport> legs, const ReportOptions& options);

// Returns a line of comma-separated values for each team of each leg.
std::string numbers_csv(const std::vector<LegReport>& legs);

// Returns how goals fell against each team, where it lost the ball and which laws it broke, with
// record and tick, as lines for a terminal. With a name, returns only the lines of this team.
std::string goals_text(const std::vector<LegReport>& legs, const std::string& team = "");

// Returns a line of comma-separated values for each goal and each foul.
std::string goals_csv(const std::vector<LegReport>& legs);

// Returns a share as "47 %"; "-" for an empty share.
std::string percent(const std::optional<double>& share);

}  // namespace mirocup::statistics
