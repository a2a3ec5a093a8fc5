// SPDX-License-Identifier: MIT
#include "tournaments/league/class_list.hpp"

#include "system/csv.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"
#include "tournaments/league/headings.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <system_error>
#include <unicode/bytestream.h>
#include <unicode/normalizer2.h>
#include <utility>

namespace mirocup::league {

namespace {

constexpr std::size_t max_kept = 20;  // further columns
constexpr std::size_t max_team_name = 40;
constexpr std::size_t max_cell = 200;  // bytes of a cell in one of them
constexpr std::string_view expected =
    "the first line names the columns, as in team,display,members: ";

std::string at_line(int line, const std::string& what) {
  return "line " + std::to_string(line) + ": " + what;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

// Returns the name of a team for a group: "Gruppe-1" for "Gruppe 1". Of other letters only the
// accents are left out; "": nothing is left.
std::string name_for(const std::string& group) {
  UErrorCode error = U_ZERO_ERROR;
  std::string letters;
  icu::StringByteSink<std::string> sink(&letters);
  if (const auto* apart = icu::Normalizer2::getNFKDInstance(error))
    apart->normalizeUTF8(0, system::replaced(group, "ß", "ss"), sink, nullptr, error);
  std::string name;
  for (const char c : letters) {
    const bool is_letter = system::is_plain(c) && c != '-';
    if (static_cast<unsigned char>(c) >= 0x80) continue;
    if (is_letter || (!name.empty() && name.back() != '-')) name += is_letter ? c : '-';
  }
  name.erase(0, name.find_first_not_of(".-"));
  name.resize(std::min(name.size(), max_team_name));
  name.erase(name.find_last_not_of('-') + 1);
  return is_good_name(group) ? group : name;
}

// Returns the groups that a cell names, between commas, as Moodle writes them.
std::vector<std::string> groups_in(const std::string& cell) {
  constexpr std::string_view none =
      "|-|–|none|no group|no groups|keine|keine gruppe|keine gruppen|ohne gruppe|";
  if (none.find('|' + system::lower_case(cell) + '|') != std::string_view::npos) return {};
  return members_of(system::replaced(cell, ",", ";"));
}

class ClassListReader {
 public:
  explicit ClassListReader(system::CsvTable table) : table_(std::move(table)) {}

  Result<ClassList> read(const std::string& words) {
    const std::vector<system::CsvRow>& rows = table_.rows;
    if (const auto done = read_headings(words); !done)
      return fail(Errc::input, at_line(rows[0].line, done.error().what));
    look_through();
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (const auto done = take(rows[i]); !done)
        return fail(Errc::input, at_line(rows[i].line, done.error().what));
    }
    for (ClassListRow& row : list_.rows)
      std::erase_if(row.people.more, [](const auto& one) {
        return one.second.find_first_not_of("; ") == std::string::npos;
      });
    list_.was_windows_1252 = table_.was_windows_1252;
    return std::move(list_);
  }

 private:
  bool has(const std::string& field) const {
    return std::ranges::find(names_, field) != names_.end();
  }

  // Returns what a row says in the column of this name; "": nothing.
  std::string cell(const system::CsvRow& row, const std::string& name) const {
    const auto at = std::ranges::find(names_, name) - names_.begin();
    return at < std::ssize(names_) && at < std::ssize(row.cells) ? row.cells[at] : "";
  }

  // Columns at the end that have no name are left out.
  Result<void> read_headings(const std::string& words) {
    names_ = table_.rows[0].cells;
    while (names_.back().empty()) names_.pop_back();
    for (std::string& name : names_) name = system::replaced(name, "\n", " ");
    MIROCUP_TRY_VOID(name_fields(names_, words));
    list_.has_display = has("display");
    list_.has_members = has("members") || has("first") || has("last");
    for (const std::string& name : names_) {
      if (name.empty()) return fail(Errc::input, "a column has no name");
      if (std::ranges::count(names_, name) > 1)
        return fail(Errc::input, "two columns are called \"" + system::printable(name) + '"');
      const std::string hidden = system::hidden_character(name);
      if (system::printable(name) != name || !hidden.empty() || name.size() > max_cell)
        return fail(Errc::input, system::in_quotes(name) + " is no name of a column");
      constexpr std::string_view fields = " team display members first last ";
      if (fields.find(' ' + name + ' ') == std::string_view::npos) list_.kept.push_back(name);
    }
    if (!has("team")) {
      return fail(Errc::input,
                  std::string(expected) +
                      "there is no column \"team\"; --columns team=HEADING names another one: " +
                      system::printable(system::joined(table_.rows[0].cells, ", ")));
    }
    if (list_.kept.size() > max_kept)
      return fail(Errc::input, "at most " + std::to_string(max_kept) + " further columns are kept");
    return {};
  }

  // Finds out what kind of list this is: one with a line for each team has the column "team" and
  // each team once.
  void look_through() {
    by_student_ =
        has("first") || has("last") || system::lower_case(cell(table_.rows[0], "team")) != "team";
    std::set<std::string> teams;
    for (std::size_t i = 1; i < table_.rows.size(); ++i) {
      const std::string team = cell(table_.rows[i], "team");
      by_student_ = by_student_ || (!team.empty() && !teams.insert(team).second);
      has_mails_ = has_mails_ || !cell(table_.rows[i], heading_of("mail", names_)).empty();
      list_.has_several_groups |= by_student_ && groups_in(team).size() > 1;
    }
  }

  // Returns the group of a student that is the team; "": none. If students have several, as
  // "Team 1, Lab A", a team begins with a word for teams. In a list by team, the cell is the team.
  Result<std::string> team_among(const std::string& cell) const {
    if (!by_student_) return cell;
    std::vector<std::string> groups = groups_in(cell);
    const bool are_several = groups.size() > 1;
    std::erase_if(groups, [&](const std::string& group) {
      const std::string name = system::lower_case(group);
      return list_.has_several_groups && !name.starts_with("team") && !name.starts_with("gruppe") &&
             !name.starts_with("group");
    });
    if (groups.size() == 1 || (groups.empty() && !are_several)) return system::joined(groups, "");
    return fail(Errc::input, system::in_quotes(cell) +
                                 " are several groups: write the team alone, as \"Team 1\"");
  }

  Result<People> read_people(const system::CsvRow& row) const {
    const std::vector<std::string>& cells = row.cells;
    for (std::size_t i = names_.size(); i < cells.size(); ++i) {
      if (!cells[i].empty())
        return fail(Errc::input, "it has more cells than the first line has columns");
    }
    if (cells.size() < names_.size()) {
      return fail(Errc::input, std::to_string(names_.size()) + " cells are expected, and it has " +
                                   std::to_string(cells.size()));
    }
    People people;
    people.display = cell(row, "display");
    // A "name" beside a surname is the first name, and beside a first name the surname.
    const bool is_whole = has("first") && has("last");
    people.members = members_of(cell(row, "first") + ' ' +
                                (is_whole ? "" : cell(row, "members") + ' ') + cell(row, "last"));
    for (const std::string& name : list_.kept) {
      std::string text = system::replaced(cell(row, name), "\n", ";");
      // So a spreadsheet keeps the zeros of a number: ="0042".
      if (text.starts_with("=\"") && text.ends_with('"')) text = text.substr(2, text.size() - 3);
      if (name == heading_of("mail", names_)) text.erase(text.find_last_not_of("; ") + 1);
      if (text.size() > max_cell || system::printable(text) != text)
        return fail(Errc::input, name + ": one line of text of at most " +
                                     std::to_string(max_cell) + " bytes is expected");
      people.more.emplace_back(name, text);
    }
    return people;
  }

  // Returns why the cells of a line would be given to wrong students; "": they would not.
  std::string objection_to_cells(const People& people) const {
    for (const std::string& member : people.members) {
      const std::size_t comma = member.find(',');
      if (comma == std::string::npos) continue;
      const std::string instead = by_student_
                                      ? member.substr(comma + 1) + ' ' + member.substr(0, comma)
                                      : system::replaced(member, ",", ";");
      return system::in_quotes(member) + " has a comma: write " +
             system::in_quotes(system::joined(parts_of(instead), "; ")) +
             ", with ; between two members";
    }
    for (const std::string field : {"mail", "number"}) {
      const bool is_mail = field == "mail";
      const std::string text = said_of(people, field);
      std::vector<std::string> parts = parts_of(text);
      if (text.empty()) parts.clear();
      for (const std::string& part : parts) {
        const bool is_one = !is_mail || std::ranges::count(part, '@') == 1;
        if (!is_one || part.find_first_of(is_mail ? ", " : ",") != std::string::npos)
          return system::in_quotes(part) + " is no " + field +
                 ": write it alone, with ; between two";
      }
      const bool is_needed = list_.has_members && (is_mail ? has_mails_ : !parts.empty());
      if (is_needed && parts.size() != people.members.size())
        return counted(people.members.size(), "member") + ", but " + counted(parts.size(), field) +
               ": each member needs one, with ; between two";
    }
    return "";
  }

  // Takes a line: a team, or a student into a team.
  Result<void> take(const system::CsvRow& row) {
    MIROCUP_TRY(People people, read_people(row));
    MIROCUP_TRY(const std::string group, team_among(cell(row, "team")));
    const std::string mails = said_of(people, "mail");
    const std::string who = people.members.empty() ? mails : people.members[0];
    if (by_student_ && group.empty()) {
      list_.without_team.push_back(who + " (line " + std::to_string(row.line) + ")");
      return {};
    }
    const std::string team = by_student_ ? name_for(group) : group;
    if (!is_good_name(team)) {
      return fail(Errc::input, system::in_quotes(group) +
                                   " is no name of a team: letters, digits, '-', '_' and '.', at "
                                   "most 40; other letters are for the column \"display\"");
    }
    if (const std::string why = objection_to_cells(people); !why.empty())
      return fail(Errc::input, (by_student_ ? who : team) + ": " + why);
    if (people.display.empty() && team != group) people.display = group;
    const std::string id = system::lower_case(mails + ' ' + said_of(people, "number"));
    const auto [before, is_new] = students_.emplace(id, row.line);
    if (by_student_ && !is_new && id != " ")
      return fail(Errc::input, who + " is in line " + std::to_string(before->second) + " as well");
    list_.members += people.members.size();
    list_.mails += mails.empty() ? 0 : parts_of(mails).size();
    // The values of one student are joined to those of others by semicolons.
    if (by_student_ && people.members.size() == 1)
      for (auto& [heading, value] : people.more) value = system::replaced(value, ";", ",");
    return add({.line = row.line, .team = team, .people = people});
  }

  // Adds a new team, or the students of a line to the team that has them.
  Result<void> add(const ClassListRow& row) {
    const auto [place, is_new] = places_.emplace(system::lower_case(row.team), list_.rows.size());
    if (is_new) list_.rows.push_back(row);
    ClassListRow& team = list_.rows[place->second];
    People& people = team.people;
    const bool is_same = row.team == team.team && row.people.display == people.display;
    if (!is_new && (!by_student_ || !is_same)) {
      const std::string other = people.display.empty() ? team.team : people.display;
      return fail(Errc::input, row.team + " is in line " + std::to_string(team.line) + " as well" +
                                   (by_student_ ? ", as " + system::in_quotes(other) +
                                                      ": write that, or another name"
                                                : ": one line for each team"));
    }
    if (!is_new) {
      const std::vector<std::string>& members = row.people.members;
      people.members.insert(people.members.end(), members.begin(), members.end());
      for (std::size_t i = 0; i < people.more.size(); ++i)
        people.more[i].second += "; " + row.people.more[i].second;
    }
    const std::string why = objection_to(people);
    return why.empty() ? Result<void>() : fail(Errc::input, row.team + ": " + why);
  }

  system::CsvTable table_;
  ClassList list_;
  std::vector<std::string> names_;  // of the columns
  bool by_student_ = false;         // the list has a line for each student
  bool has_mails_ = false;
  std::map<std::string, std::size_t> places_;  // of teams in the list, by the name in small letters
  std::map<std::string, int> students_;        // lines, by mail and number
};

std::string class_list_path(const Folder& folder) {
  return folder.path + "/class-list";
}

}  // namespace

Result<ClassList> read_class_list(std::string_view bytes, const std::string& columns) {
  MIROCUP_TRY(auto table, system::read_csv(bytes));
  if (table.rows.empty())
    return fail(Errc::input, at_line(1, std::string(expected) + "it is empty"));
  return ClassListReader(std::move(table)).read(columns);
}

std::string ClassList::size_in_words() const {
  return counted(rows.size(), "team") +
         (members + mails > 0 ? ", " + counted(members, "member") : "") +
         (mails > 0 ? ", " + counted(mails, "mail") : "");
}

Result<std::vector<std::string>> ClassList::merge_into(PeopleOfTeams& people,
                                                       const LeagueState& state) const {
  std::vector<std::string> joining;
  for (const ClassListRow& row : rows) {
    People& one = people[row.team];
    if (has_display || one.display.empty()) one.display = row.people.display;
    if (has_members) one.members = row.people.members;
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
    const bool comes_later = std::ranges::any_of(rows, [&](const ClassListRow& one) {
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
