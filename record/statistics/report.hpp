// SPDX-License-Identifier: MIT
//
// Statistics for people and for tables: what `mirocup stats` prints.
#pragma once

#include "record/statistics/totals.hpp"

#include <string>
#include <vector>

namespace mirocup::statistics {

// What is printed, and how.
struct ReportOptions {
  bool goals = false;  // how goals fell and balls were lost, instead of the numbers
  std::string team;    // only its legs, and how goals fell against it; "": of all teams
  bool csv = false;    // comma-separated values, and no text for people
  bool json = false;   // one object
};

// Returns what `mirocup stats` prints about these legs. JSON holds both subjects. Errors:
// Errc::input if no leg is of the team.
Result<std::string> report(std::vector<LegReport> legs, const ReportOptions& options);

// Each team over all legs; lines for a terminal.
std::string numbers_text(const std::vector<LegReport>& legs);

// One line for each team of each leg.
std::string numbers_csv(const std::vector<LegReport>& legs);

// How goals fell against each team, where it lost the ball and which laws it broke, with record and
// tick; lines for a terminal. With a name, of this team alone.
std::string goals_text(const std::vector<LegReport>& legs, const std::string& team = "");

// One line for each goal and each foul.
std::string goals_csv(const std::vector<LegReport>& legs);

// The share as "47 %"; "-" if there is none.
std::string percent(const std::optional<double>& share);

}  // namespace mirocup::statistics
