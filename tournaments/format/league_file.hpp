// SPDX-License-Identifier: MIT
//
// league.json: the settings that the host chose for a league. It may be edited until the league
// starts.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/referee/rules.hpp"
#include "tournaments/format/format.hpp"
#include "tournaments/table/table.hpp"

#include <string>
#include <vector>

namespace mirocup::league {

// The source of a team's library, and where the team's process runs.
struct TeamConfig {
  std::string name;
  std::string source;     // as written: "house:NAME", a path, or "submitted"
  bool over_dds = false;  // true: `mirocup join` runs it; false: the match server does
};

struct LeagueFile {
  std::string title = "League";
  Format format;
  League league = League::small;
  referee::Rules rules;
  std::uint64_t seed = 1;
  Points points;
  std::vector<TieBreak> tie_breaks{default_tie_breaks.begin(), default_tie_breaks.end()};
  std::string freeze;  // time after which no entry is taken, "2026-11-30T18:00:00Z"; "": the start
  int strikes = 3;     // legs lost in a row by own faults that pause a team; 0: it is never paused
  std::vector<TeamConfig> teams;

  TableRules table_rules() const { return {points, tie_breaks, seed}; }
};

// True if a team may have this name: it becomes the name of a folder, of DDS partitions and of
// pages.
bool is_good_name(const std::string& name);

// Reads the text of a league.json. `path` is used for the error (Errc::input) only, which names the
// file, the place in it and the reason.
Result<LeagueFile> parse_league_file(const std::string& text, const std::string& path);

// Returns the text of the league.json that parse_league_file() reads as this league.
std::string print_league_file(const LeagueFile& league);

}  // namespace mirocup::league
