// SPDX-License-Identifier: MIT
//
// The pages and data files of a league, made from its state alone: the same state gives the same
// bytes, so site/ may be deleted and made again.
#pragma once

#include "tournaments/run/league_state.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

struct SiteFile {
  std::string name;  // inside site/
  std::string bytes;
};

// index.html, table.json, crosstable.json, bracket.json.
std::vector<SiteFile> make_site(const LeagueState& state);

// The table as lines of text, for a terminal.
std::string table_text(const LeagueState& state);

// The table as JSON, as in table.json.
Json table_json(const LeagueState& state);

}  // namespace mirocup::league
