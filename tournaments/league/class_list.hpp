// SPDX-License-Identifier: MIT
//
// A class list: a table of teams and their members, as a spreadsheet writes it. The first row names
// the columns (headings.hpp). A list has one line for each team, with ; between its members, or one
// for each student. Columns that say something else are kept.
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
  std::vector<std::string> kept;  // headings of the further columns
  std::size_t members = 0;        // of all teams
  std::size_t mails = 0;
  std::vector<std::string> without_team;  // students without a group: "Zoë Brandt (line 7)"
  bool has_several_groups = false;        // a student is in several, of which one is the team
  bool was_windows_1252 = false;

  std::string size_in_words() const;  // "10 teams, 30 members, 30 mails"

  // Replaces the data of the teams in the rows. If the list lacks a column, the data of that column
  // stays. Returns the teams that the league does not know. Errors (Errc::input) begin with the
  // line; reasons are a name that people could take for another team's, or a team that cannot join.
  Result<std::vector<std::string>> merge_into(PeopleOfTeams& people,
                                              const LeagueState& state) const;
};

// Reads a class list. `columns`: what a person says of the columns, as name_fields() takes it. In a
// list with a line for each student the lines of a team are joined; then a team's name is that of
// its group, and a group whose name cannot be a team's gets a similar one and keeps its own as
// display name. If students have several groups, those that begin with Team, Gruppe or Group are
// the teams. Errors: Errc::input, a sentence with the line and the reason.
Result<ClassList> read_class_list(std::string_view bytes, const std::string& columns = "");

// Keeps the last class list of a league and its path, so that no command overwrites the list.
Result<void> remember_class_list(system::Files& files, const Folder& folder,
                                 const std::string& path, const std::string& bytes);

// Refuses to write to `path` if it is the kept list (Errc::input). If a shell has emptied the list
// because it redirects this program's output to it, fills the list again.
Result<void> spare_class_list(system::Files& files, const Folder& folder, const std::string& path);

}  // namespace mirocup::league
