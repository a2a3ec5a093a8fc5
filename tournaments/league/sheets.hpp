// SPDX-License-Identifier: MIT
//
// The sheets of exercises in a league: until when entries count, in sheets.json, and the scores
// that the host has released. The host may change sheets.json at any time.
#pragma once

#include "core/base/error.hpp"
#include "system/files.hpp"
#include "tournaments/format/league_file.hpp"
#include "tournaments/league/folder.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace mirocup::league {

// All times are UTC, as utc_text() returns them.
struct SheetDeadline {
  std::string until;
  std::string grace;                              // the end of the days of grace after `until`
  std::map<std::string, std::string> extensions;  // by team: in place of `grace`

  // Returns the last time at which a team can hand in an entry that counts.
  const std::string& of(const std::string& team) const {
    const auto found = extensions.find(team);
    return found == extensions.end() ? grace : found->second;
  }
};

// By the name of the sheet.
using SheetDeadlines = std::map<std::string, SheetDeadline>;

// Reads sheets.json; nothing if there is none. An error is Errc::input, and names file and key.
Result<SheetDeadlines> read_sheet_deadlines(system::Files& files, const Folder& folder,
                                            const LeagueFile& file);

// The scores of a sheet's report, as it writes them: by team, and by sheet.
using SheetScores = std::map<std::string, std::map<std::string, std::string>>;

// Lets each team of the league see its scores, in place of those that were released before.
Result<void> release_scores(system::Files& files, const Folder& folder, const LeagueFile& file,
                            const SheetScores& scores);

// Returns a row for each sheet of which a team may know something: its name `sheet`, `until`, `own`
// (until when this team may hand in), and `score`; "" for what there is not.
Result<nlohmann::ordered_json> sheets_of_team(system::Files& files, const Folder& folder,
                                              const LeagueFile& file, const std::string& team);

}  // namespace mirocup::league
