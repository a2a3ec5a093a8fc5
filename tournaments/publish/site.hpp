// SPDX-License-Identifier: MIT
//
// The league as a folder of pages that work from disk, and as files for other programs. A pure
// function of where the league stands: the same journal, played in whatever order, gives the same
// bytes.
#pragma once

#include "tournaments/publish/leg_view.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct SiteFile {
  std::string name;  // inside site/
  std::string bytes;
};

// index.html, a page for each team below teams/, and what exports() gives.
std::vector<SiteFile> make_site(const LeagueState& state);

// table.json, crosstable.json, bracket.json, legs.json, table.csv, legs.csv.
std::vector<SiteFile> exports(const Overview& overview);

// The page of a team, inside site/.
std::string team_page_of(const std::string& team);
std::string team_html(const Overview& overview, int team);

// The table as lines of text, for a terminal.
std::string table_text(const LeagueState& state);

// The table as JSON, as in table.json.
Json table_json(const Overview& overview);

// The scores of all meetings of two teams, "2:1", as the row's team sees them.
using Meetings = std::vector<std::vector<std::vector<std::string>>>;
Meetings meetings(const Overview& overview);

}  // namespace mirocup::league
