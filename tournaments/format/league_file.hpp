// SPDX-License-Identifier: MIT
//
// league.json: what the host decided. It may be edited until the league starts.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/referee/rules.hpp"
#include "tournaments/format/format.hpp"
#include "tournaments/table/table.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// How a team gets its library, and where it runs.
struct TeamConfig {
  std::string name;
  std::string source;     // as written: "house:NAME", a path, or "submitted"
  bool over_dds = false;  // plays through mirocup join instead of in the match server's care
};

struct LeagueFile {
  std::string title = "League";
  Format format;
  League league = League::small;
  referee::Rules rules;
  std::uint64_t seed = 1;
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};
  std::string
      freeze;       // "2026-11-30T18:00:00Z": no entry is taken from then on; "": until the start
  int strikes = 3;  // so many legs in a row lost by an own fault pause a team; 0: none do
  std::vector<TeamConfig> teams;

  TableRules table_rules() const { return {points, tie_breaks, seed}; }
};

// May a team be called so? Names become folders, partitions, pages and lines of tables.
bool is_good_name(const std::string& name);

// `path` is for error messages, which name the file, the place and the reason (Errc::input).
Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path);
std::string print_league_file(const LeagueFile& league);

}  // namespace mirocup::league
