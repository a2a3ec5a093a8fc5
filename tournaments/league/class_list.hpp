// SPDX-License-Identifier: MIT
//
// A class list: a table of teams and who is in them, as a spreadsheet writes it. Its first row
// names the columns: `team`, and any of `display`, `members` (with ; between them) and `colour`.
// Further columns are kept as they are.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/league/people.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

struct ClassListRow {
  int line = 1;  // of the file
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

  // Replaces the data of the teams in the rows. If the list lacks a column, that part of the data
  // stays. Returns the teams that the league does not know. Errors (Errc::input) begin with the
  // line: a name that people could take for another team's, or a team that cannot join.
  Result<std::vector<std::string>> merge_into(PeopleOfTeams& people,
                                              const LeagueState& state) const;
};

// Errors: Errc::input, a sentence with the line and the reason.
Result<ClassList> read_class_list(std::string_view bytes);

// Keeps the last class list of a league and its path, so that no command overwrites the list.
Result<void> remember_class_list(system::Files& files, const Folder& folder,
                                 const std::string& path, const std::string& bytes);

// Refuses to write to `path` if it is that list (Errc::input). If the list is empty, because a
// shell empties a file before the program runs, fills it again.
Result<void> spare_class_list(system::Files& files, const Folder& folder, const std::string& path);

}  // namespace mirocup::league
