// SPDX-License-Identifier: MIT
//
// The subcommands verify, backup, grades and team.
#include "programs/league/commands.hpp"
#include "record/json_reader.hpp"
#include "system/csv.hpp"
#include "system/file_lock.hpp"
#include "system/printable.hpp"
#include "tournaments/league/kept_program.hpp"
#include "tournaments/league/people.hpp"
#include "tournaments/play/backup.hpp"
#include "tournaments/play/program.hpp"
#include "tournaments/publish/grades.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace mirocup::league {

Result<int> run_verify_league(const LeagueOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  if (options.trusts_programs) {
    MIROCUP_TRY(const auto trusted, trust_kept_programs(disk, store.folder()));
    for (const std::string& path : trusted)
      std::cerr << "mirocup: " << system::printable(path) << " is trusted from now on\n";
  }
  MIROCUP_TRY(const auto done, verify_records(disk, store, options.jobs));
  int result = exit_yes;
  for (const auto& problem : done.problems) result = std::max(result, problem.code);
  if (options.json) {
    Json problems = Json::array();
    for (const auto& p : done.problems)
      problems.push_back({{"record", p.record}, {"code", p.code}, {"what", p.text}});
    std::cout << record::json_text({{"records", done.records},
                                    {"reproduced", done.reproduced},
                                    {"programs", done.programs},
                                    {"problems", problems}})
              << '\n';
    return result;
  }
  for (const auto& problem : done.problems)
    std::cout << system::printable(problem.record) << ": " << system::printable(problem.text)
              << '\n';
  for (const std::string& program : done.programs) std::cout << system::printable(program) << '\n';
  std::cout << done.reproduced << " of " << done.records << " records reproduced\n";
  return result;
}

Result<int> run_backup(const BackupOptions& options) {
  system::Disk disk;
  // Is it a league?
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto done, back_up(disk, Folder{options.folder}, Folder{options.to}));
  std::cout << options.to << ": " << done.copied << " files copied, " << done.known
            << " records were there\n";
  return exit_yes;
}

Result<int> run_grades(const LeagueOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  std::string drills;
  if (!options.drills.empty()) {
    MIROCUP_TRY(drills, disk.read(options.drills, {.max_size = system::size_limit::note,
                                                   .links = system::Links::followed}));
  }
  MIROCUP_TRY(const auto people, read_people(disk, folder));
  MIROCUP_TRY(const auto file, grades(overview(store.state()), people, drills, options.drills));
  if (options.output.empty()) {
    std::cout << file.bytes;
    return exit_yes;
  }
  MIROCUP_TRY_VOID(disk.write(options.output, file.bytes, system::Readers::owner));
  std::cout << options.output << '\n';
  return exit_yes;
}

namespace {

Result<void> set_display(PeopleOfTeams& people, const std::string& team,
                         const std::string& display) {
  if (const std::string why = display.empty() ? "" : objection_to_display(display); !why.empty())
    return fail(Errc::input, team + ": " + why);
  people[team].display = display;
  return {};
}

Result<void> set_members(PeopleOfTeams& people, const std::string& team,
                         const std::vector<std::string>& members) {
  for (const std::string& member : members) {
    if (const std::string why = objection_to_display(member); !why.empty())
      return fail(Errc::input, team + ": " + why);
  }
  people[team].members = members;
  return {};
}

Result<void> set_colour_of(PeopleOfTeams& people, const std::string& team,
                           const std::string& colour) {
  const auto set = set_colour(people[team], colour);
  return set ? set : fail(Errc::input, team + ": " + set.error().what);
}

// Reads lines of team, display name, members with semicolons between them and, if the first line
// names that column, the colour.
Result<void> read_class_list(const std::string& text, const std::string& path,
                             PeopleOfTeams& people) {
  std::size_t begin = 0;
  std::size_t columns = 0;
  for (int number = 1; number == 1 || begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::vector<std::string> cells = system::csv_cells(line);
    const std::string where = path + ": line " + std::to_string(number);
    if (number == 1) {
      columns = cells.size();
      const std::vector<std::string> names{"team", "display", "members", "colour"};
      if (columns < 3 || columns > 4 || !std::equal(cells.begin(), cells.end(), names.begin()))
        return fail(Errc::input, where +
                                     ": \"team,display,members\" is expected, or "
                                     "\"team,display,members,colour\"");
      continue;
    }
    if (line.empty()) continue;
    if (cells.size() != columns || !is_good_name(cells[0]))
      return fail(Errc::input, where + ": a team, its display name and its members are expected" +
                                   (columns > 3 ? ", and its colour" : ""));
    std::vector<std::string> members;
    for (std::size_t at = 0; at < cells[2].size();) {
      const std::size_t stop = std::min(cells[2].find(';', at), cells[2].size());
      std::string member = cells[2].substr(at, stop - at);
      member.erase(0, member.find_first_not_of(' '));
      if (!member.empty()) members.push_back(member);
      at = stop + 1;
    }
    auto set = set_display(people, cells[0], cells[1]).and_then([&] {
      return set_members(people, cells[0], members);
    });
    if (set && columns > 3) set = set_colour_of(people, cells[0], cells[3]);
    if (!set) return fail(Errc::input, where + ": " + set.error().what);
  }
  return {};
}

}  // namespace

Result<int> run_team(const TeamOptions& options) {
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  MIROCUP_TRY(auto people, read_people(disk, folder));
  Result<void> set;
  if (!options.csv.empty()) {
    if (!options.team.empty()) return fail(Errc::input, "TEAM and --csv exclude each other");
    MIROCUP_TRY(const auto text,
                disk.read(options.csv, {.max_size = system::size_limit::league_file,
                                        .links = system::Links::followed}));
    set = read_class_list(text, options.csv, people);
  } else {
    if (!is_good_name(options.team)) return fail(Errc::input, "TEAM or --csv FILE is expected");
    if (!store.state().find_team(options.team))
      return fail(Errc::input, "there is no team " + options.team);
    if (options.display) set = set_display(people, options.team, *options.display);
    if (set && !options.members.empty()) set = set_members(people, options.team, options.members);
    if (set && options.colour) set = set_colour_of(people, options.team, *options.colour);
  }
  if (!set) return tl::unexpected(set.error());
  MIROCUP_TRY_VOID(write_people(disk, folder, people));
  for (const auto& [team, one] : people) {
    std::cout << team << ": " << (one.display.empty() ? team : one.display);
    for (std::size_t i = 0; i < one.members.size(); ++i)
      std::cout << (i == 0 ? " (" : "; ") << one.members[i];
    std::cout << (one.members.empty() ? "" : ")") << (one.colour.empty() ? "" : " ") << one.colour
              << '\n';
  }
  return exit_yes;
}

}  // namespace mirocup::league
