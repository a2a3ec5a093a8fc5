// SPDX-License-Identifier: MIT
//
// mirocup league team: makes teams, and says by what names people know them.
#include "programs/league/commands.hpp"
#include "system/file_lock.hpp"
#include "system/text.hpp"
#include "tournaments/handin/tokens.hpp"
#include "tournaments/league/book.hpp"
#include "tournaments/league/class_list.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

struct TeamOptions : LeagueOptions {
  std::string team;
  std::optional<std::string> display;
  std::vector<std::string> members;
  std::string csv;      // a class list; "": one team
  std::string columns;  // of the class list
  bool is_dry_run = false;
  bool is_removed = false;  // a team that was a mistake
};

void print(const std::string& team, const People& one) {
  std::cout << team << ": " << (one.display.empty() ? team : one.display);
  if (!one.members.empty()) std::cout << " (" << system::joined(one.members, "; ") << ")";
  std::cout << '\n';
}

// Takes a class list: its teams, and who is in them.
Result<int> take_class_list(system::Files& files, LeagueStore& store, const TeamOptions& options) {
  const std::string& path = options.csv;
  const Folder& folder = store.folder();
  MIROCUP_TRY(const auto bytes, files.read_named(path, system::size_limit::league_file));
  const auto in_file = [&path](const Error& error) {
    return Error{error.code, system::printable(path) + ": " + error.what};
  };
  MIROCUP_TRY(const auto list, read_class_list(bytes, options.columns).map_error(in_file));
  std::vector<std::string> joining;
  {
    MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
    MIROCUP_TRY(auto people, read_people(files, folder));
    MIROCUP_TRY(joining, list.merge_into(people, store.state()).map_error(in_file));
    if (!options.is_dry_run) MIROCUP_TRY_VOID(write_people(files, folder, people));
  }
  if (!options.is_dry_run) {
    MIROCUP_TRY_VOID(enter_teams(files, store, joining, std::string(TeamConfig::submitted)));
    MIROCUP_TRY_VOID(remember_class_list(files, folder, path, bytes));
  }
  std::vector<std::string> missing;
  for (const TeamConfig& team : store.state().file.teams) {
    const bool is_listed = std::ranges::count(list.rows, team.name, &ClassListRow::team) > 0;
    if (!is_listed && !team.is_house()) missing.push_back(team.name);
  }
  std::cout << system::printable(path) << ": " << list.size_in_words() << ", " << joining.size()
            << " new to the league" << (options.is_dry_run ? " (not written: a dry run)\n" : "\n");
  if (list.has_several_groups)
    std::cout << "teams are the groups that begin with Team, Gruppe or Group\n";
  const std::string without = system::joined(list.without_team, ", ");
  if (!without.empty()) std::cout << "in no team: " << system::printable(without) << '\n';
  if (!list.kept.empty())
    std::cout << "columns kept for the grades: " << system::joined(list.kept, ", ") << '\n';
  if (!missing.empty())
    std::cout << "in the league, but not in this list: " << system::joined(missing, ", ") << '\n';
  if (list.was_windows_1252) {
    std::cerr << "mirocup: " << system::printable(path)
              << " is not in UTF-8. It was read as Excel writes it in western Europe "
                 "(Windows-1252): check the names\n";
  }
  return exit_yes;
}

// Takes a team out of the class list and, before the start, out of the league.
Result<int> remove_team(system::Files& files, LeagueStore& store, const std::string& team) {
  const Folder& folder = store.folder();
  const bool is_in = store.state().find_team(team).has_value();
  MIROCUP_TRY(const auto book, Book::open(files, folder));
  const bool has_entry = book.hand_ins().last_kept(team) > 0;
  if (has_entry || (is_in && store.state().is_started))
    return fail(Errc::input,
                team + (has_entry ? " has handed in" : " is in a league that has started") +
                    ": league withdraw takes the team out of the league");
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  MIROCUP_TRY(auto people, read_people(files, folder));
  MIROCUP_TRY(auto tokens, read_tokens(files, folder));
  const int revoked = tokens.revoke(Role::team, team, "", utc_text(system::now_s()));
  if (people.erase(team) == 0 && !is_in && revoked == 0)
    return fail(Errc::input, "there is no team " + team);
  MIROCUP_TRY_VOID(write_people(files, folder, people));
  if (revoked > 0) MIROCUP_TRY_VOID(write_tokens(files, folder, tokens));
  LeagueFile file = store.state().file;
  if (std::erase_if(file.teams, [&team](const auto& one) { return one.name == team; }) > 0)
    MIROCUP_TRY_VOID(files.write(folder.config(), print_league_file(file)));
  std::cout << team << " is no longer in the league\n";
  return exit_yes;
}

Result<int> run_team(const TeamOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY_VOID(expect_league(disk, folder));
  MIROCUP_TRY(const auto alone, system::FileLock::acquire(folder.submitting()));
  MIROCUP_TRY(auto store, LeagueStore::open(disk, folder));
  const std::string& team = options.team;
  if (!options.csv.empty()) {
    if (!team.empty()) return fail(Errc::input, "TEAM and --csv exclude each other");
    return take_class_list(disk, store, options);
  }
  if (!is_good_name(team)) return fail(Errc::input, "TEAM or --csv FILE is expected");
  if (options.is_removed) return remove_team(disk, store, team);
  MIROCUP_TRY(const auto one,
              change_people(disk, folder, store.state(), team, [&options](People& known) {
                if (options.display) known.display = *options.display;
                if (!options.members.empty()) known.members = options.members;
                if (options.members == std::vector<std::string>{""}) known.members.clear();
              }));
  print(team, one);
  return exit_yes;
}

}  // namespace

void add_team(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, run_team, "team", to_take,
                  "Make teams from a class list, and set their display names",
                  {"mirocup league team spring --csv class.csv",
                   "mirocup league team spring alpha --display \"Zoë & Co\" --member Zoë"});
  command.option("TEAM", o.team, "Name of the team in the league");
  command.option("--display NAME", o.display, "Display name, of any letters; \"\": none");
  command.option("--member NAME", o.members,
                 "Member of the team; may be given once for each member; \"\": no members");
  const system::Option csv =
      command.option("--csv FILE", o.csv,
                     "Make the teams of this class list: a line for each team (team, display, "
                     "members with ; between them, further columns for the grades), or for "
                     "each student, as Moodle, Artemis and Excel write it");
  command
      .option("--columns KEY=HEADING,...", o.columns,
              "Headings of columns that mirocup does not know; KEY is team, display, members, "
              "first, last, mail or number, as in team=Gruppe,mail=Kontakt")
      .needs(csv);
  command
      .flag("--dry-run", o.is_dry_run, "Print what the class list would change, and change nothing")
      .needs(csv);
  command.flag("--remove", o.is_removed, "Remove a team that was added by mistake");
}

}  // namespace mirocup::league
