// SPDX-License-Identifier: MIT
#include "tournaments/league/class_list.hpp"

#include "system/csv.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>

namespace mirocup::league {

namespace {

constexpr std::size_t max_kept = 20;   // further columns
constexpr std::size_t max_cell = 200;  // bytes of a cell in one of them
constexpr std::string_view expected =
    "the first line names the columns, as in team,display,members: ";

// Reads the names of the columns. Columns at the end that have none are left out.
Result<ClassList> read_columns(std::vector<std::string>& names) {
  ClassList list;
  while (!names.empty() && names.back().empty()) names.pop_back();
  for (std::string& name : names) {
    const std::string plain = system::lower_case(name);
    if (plain == "member" || plain == "members") name = "members";
    if (plain == "color" || plain == "colour") name = "colour";
    if (plain == "team" || plain == "display") name = plain;
    if (name.empty()) return fail(Errc::input, "a column has no name");
    if (std::count(names.begin(), names.end(), name) > 1)
      return fail(Errc::input, "two columns are called \"" + system::printable(name) + '"');
    const std::string hidden = system::hidden_character(name);
    if (system::printable(name) != name || !hidden.empty() || name.size() > max_cell)
      return fail(Errc::input, system::in_quotes(name) + " is no name of a column");
    list.has_display = list.has_display || name == "display";
    list.has_members = list.has_members || name == "members";
    list.has_colour = list.has_colour || name == "colour";
    if (name != "team" && name != "display" && name != "members" && name != "colour")
      list.kept.push_back(name);
  }
  if (std::find(names.begin(), names.end(), "team") == names.end())
    return fail(Errc::input, std::string(expected) + "there is no column \"team\"");
  if (list.kept.size() > max_kept)
    return fail(Errc::input, "at most " + std::to_string(max_kept) + " further columns are kept");
  return list;
}

Result<ClassListRow> read_row(const std::vector<std::string>& names,
                              const std::vector<std::string>& cells) {
  ClassListRow row;
  for (std::size_t i = names.size(); i < cells.size(); ++i) {
    if (!cells[i].empty())
      return fail(Errc::input, "it has more cells than the first line has columns");
  }
  if (cells.size() < names.size()) {
    return fail(Errc::input, std::to_string(names.size()) + " cells are expected, and it has " +
                                 std::to_string(cells.size()));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& cell = cells[i];
    if (names[i] == "team") {
      row.team = cell;
    } else if (names[i] == "display") {
      row.people.display = cell;
    } else if (names[i] == "members") {
      row.people.members = members_of(cell);
    } else if (names[i] == "colour") {
      MIROCUP_TRY_VOID(set_colour(row.people, cell));
    } else if (!cell.empty()) {
      std::string text = cell;
      std::replace(text.begin(), text.end(), '\n', ';');
      if (text.size() > max_cell || system::printable(text) != text)
        return fail(Errc::input, names[i] + ": one line of text of at most " +
                                     std::to_string(max_cell) + " bytes is expected");
      row.people.more.emplace_back(names[i], text);
    }
  }
  if (!is_good_name(row.team)) {
    return fail(Errc::input, system::in_quotes(row.team) +
                                 " is no name of a team: letters, digits, '-', '_' and '.', at "
                                 "most 40; other letters are for the column \"display\"");
  }
  if (const std::string why = objection_to(row.people); !why.empty())
    return fail(Errc::input, row.team + ": " + why);
  return row;
}

std::string at_line(int line, const std::string& what) {
  return "line " + std::to_string(line) + ": " + what;
}

std::string class_list_path(const Folder& folder) {
  return folder.path + "/class-list";
}

}  // namespace

Result<ClassList> read_class_list(std::string_view bytes) {
  MIROCUP_TRY(auto table, system::read_csv(bytes));
  if (table.rows.empty())
    return fail(Errc::input, at_line(1, std::string(expected) + "it is empty"));
  auto list = read_columns(table.rows[0].cells);
  if (!list) return fail(Errc::input, at_line(table.rows[0].line, list.error().what));
  list->was_windows_1252 = table.was_windows_1252;
  std::map<std::string, int> lines;  // by the name in small letters
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const int line = table.rows[i].line;
    auto row = read_row(table.rows[0].cells, table.rows[i].cells);
    if (!row) return fail(Errc::input, at_line(line, row.error().what));
    row->line = line;
    const auto [before, is_new] = lines.emplace(system::lower_case(row->team), line);
    if (!is_new) {
      return fail(Errc::input,
                  at_line(line, row->team + " is in line " + std::to_string(before->second) +
                                    " as well: one line for each team"));
    }
    list->rows.push_back(*std::move(row));
  }
  return list;
}

Result<std::vector<std::string>> ClassList::merge_into(PeopleOfTeams& people,
                                                       const LeagueState& state) const {
  std::vector<std::string> joining;
  for (const ClassListRow& row : rows) {
    People& one = people[row.team];
    if (has_display) one.display = row.people.display;
    if (has_members) one.members = row.people.members;
    if (has_colour) one.colour = row.people.colour;
    one.more = row.people.more;
    if (state.find_team(row.team)) continue;
    joining.push_back(row.team);
    std::string why = why_not_join(state, row.team);
    if (why.empty() && state.teams.size() + joining.size() > max_teams)
      why = "a league has at most " + std::to_string(max_teams) + " teams";
    if (!why.empty())
      return fail(Errc::input, at_line(row.line, row.team + " is new to the league: " + why));
  }
  for (const ClassListRow& row : rows) {
    const std::string& display = people[row.team].display;
    const std::string other = display.empty() ? "" : looks_like(people, state, row.team, display);
    // Of two in the list, the later one is told.
    const bool comes_later = std::any_of(rows.begin(), rows.end(), [&](const ClassListRow& one) {
      return one.team == other && one.line > row.line && !people[other].display.empty() &&
             !looks_like(people, state, other, people[other].display).empty();
    });
    if (!other.empty() && !comes_later) {
      return fail(Errc::input, at_line(row.line, row.team + " would be called \"" + display +
                                                     "\", and people would take it for " + other));
    }
  }
  return joining;
}

Result<void> remember_class_list(system::Files& files, const Folder& folder,
                                 const std::string& path, const std::string& bytes) {
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  if (error || whole.string().find('\n') != std::string::npos) return {};
  return files.write(class_list_path(folder), whole.string() + '\n' + bytes,
                     system::Readers::owner);
}

Result<void> spare_class_list(system::Files& files, const Folder& folder, const std::string& path) {
  MIROCUP_TRY(const auto kept,
              files.read_if_there(class_list_path(folder),
                                  {.max_size = 2 * system::size_limit::league_file}));
  if (!kept) return {};
  const std::size_t end = kept->find('\n');
  const std::string list = kept->substr(0, end);
  std::error_code error;
  if (end == std::string::npos || !std::filesystem::equivalent(path, list, error) || error)
    return {};
  const bool is_empty = std::filesystem::file_size(list, error) == 0 && !error;
  if (is_empty) std::ofstream(list, std::ios::binary) << kept->substr(end + 1);
  return fail(Errc::input, system::printable(list) + " is the class list" +
                               (is_empty ? ", which was empty; its lines were restored" : "") +
                               ": name another file, as tokens.csv");
}

}  // namespace mirocup::league
