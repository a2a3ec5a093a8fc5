// SPDX-License-Identifier: MIT
//
// A class list: a table of teams and their members, as a spreadsheet writes it. The first row names
// the columns: `team`, and any of `display`, `members` (with ; between them) and `colour`. Further
// columns are kept unchanged.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/league/people.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

struct ClassListRow {
  int line = 1;  // number of the line in the file
  std::string team;
  People people;
};

struct ClassList {
  std::vector<ClassListRow> rows;
  bool has_display = false;
  bool has_members = false;
  bool has_colour = false;
  std::vector<std::string> kept;  // names of the further columns
  bool was_windows_1252 = false;

  // Replaces the data of the teams in the rows. If the list lacks a column, the data of that column
  // stays. Returns the teams that the league does not know. Errors (Errc::input) begin with the
  // line; reasons are a name that people could take for another team's, or a team that cannot join.
  Result<std::vector<std::string>> merge_into(PeopleOfTeams& people,
                                              const LeagueState& state) const;
};

// Reads a class list. Errors: Errc::input, a sentence with the line and the reason.
Result<ClassList> read_class_list(std::string_view bytes);

// Keeps the last class list of a league and its path, so that no command overwrites the list.
Result<void> remember_class_list(system::Files& files, const Folder& folder,
                                 const std::string& path, const std::string& bytes);

// Refuses to write to `path` if it is the kept list (Errc::input). If a shell has emptied the list
// because it redirects this program's output to it, fills the list again.
Result<void> spare_class_list(system::Files& files, const Folder& folder, const std::string& path);

}  // namespace mirocup::league
