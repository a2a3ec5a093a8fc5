// SPDX-License-Identifier: MIT
//
// The league as files for other programs: JSON, and comma-separated values (RFC 4180).
#pragma once

#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// Returns table.json, crosstable.json, bracket.json, legs.json, decisions.json, table.csv, legs.csv
// and decisions.csv. The files refer to the overview, which must outlive them.
FileMakers exports(const Overview& overview);

// Returns the content of decisions.json.
std::string decisions_json(const LeagueState& state);

// Returns the content of table.json.
Json table_json(const Overview& overview);

// Returns at [first][second] the scores of all legs between two teams, such as "2:1" with the goals
// of `first` before those of `second`.
using Meetings = std::vector<std::vector<std::vector<std::string>>>;
Meetings meetings(const Overview& overview);

}  // namespace mirocup::league
