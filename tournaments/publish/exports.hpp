// SPDX-License-Identifier: MIT
//
// The league as files for other programs: JSON, and comma-separated values (RFC 4180).
#pragma once

#include "tournaments/publish/leg_view.hpp"
#include "tournaments/publish/site_file.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// table.json, crosstable.json, bracket.json, legs.json, decisions.json, table.csv, legs.csv,
// decisions.csv. Refers to the overview.
FileMakers exports(const Overview& overview);

// The content of decisions.json, as text.
std::string decisions_json(const LeagueState& state);

// The content of table.json.
Json table_json(const Overview& overview);

// The scores of all legs between two teams, [first][second]: "2:1", the goals of the first team
// first.
using Meetings = std::vector<std::vector<std::vector<std::string>>>;
Meetings meetings(const Overview& overview);

}  // namespace mirocup::league
