// SPDX-License-Identifier: MIT
//
// The subcommand token.
#include "programs/league/commands.hpp"
#include "system/csv.hpp"
#include "system/file_lock.hpp"
#include "system/text.hpp"
#include "tournaments/handin/tokens.hpp"
#include "tournaments/league/acts.hpp"
#include "tournaments/league/class_list.hpp"
#include "tournaments/league/headings.hpp"
#include "tournaments/league/submission.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

struct TokenOptions : LeagueOptions {
  std::string team;
  bool all = false;        // for each team of the league that has none
  bool staff = false;      // for those who run the league
  bool tutor = false;      // for those who only look
  bool assistant = false;  // for those who decide and see no grades
  std::string person;      // the name of the owner of such a token; "": not said
  bool csv = false;
  bool per_member = false;
  bool revoke = false;
  std::string expires;  // UTC; "": never
};

// Returns a time as league.json has it; also a day is taken, which means its end in UTC.
Result<std::string> expiry_of(const std::string& text, const LeagueFile& file,
                              const std::string& now) {
  if (text.empty()) return text;
  constexpr std::size_t length_of_day = 10;  // characters
  const std::string typed = text.size() == length_of_day ? text + "T23:59:59Z" : text;
  MIROCUP_TRY(auto time, utc_of(typed, file));
  if (time <= now) return fail(Errc::input, "--expires " + text + ": that time is past");
  return time;
}

// Returns the teams that are to get a token.
Result<std::vector<std::string>> teams_of(const TokenOptions& options, const LeagueState& state,
                                          const PeopleOfTeams& people, const TokenList& list,
                                          const std::string& now) {
  std::vector<std::string> teams;
  if (options.all) {
    for (std::size_t i = 0; i < state.teams.size(); ++i) {
      if (state.teams[i].status != TeamStatus::withdrawn) teams.push_back(state.file.teams[i].name);
    }
    for (const auto& [team, one] : people) {
      if (!state.find_team(team)) teams.push_back(team);
    }
    if (teams.empty())
      return fail(
          Errc::input,
          "the league has no team: league team DIR --csv FILE makes the teams of a class list");
    std::erase_if(teams, [&](const std::string& team) { return list.has_valid(team, now); });
    return teams;
  }
  if (!is_good_name(options.team))
    return fail(Errc::input, "\"" + options.team +
                                 "\" is no name: letters, digits, '-', '_' and '.', at most 40");
  // A team that will join is named here for the first time.
  if (!options.revoke && !state.find_team(options.team)) {
    if (const std::string why = why_not_now(state, options.team, now); !why.empty())
      return fail(Errc::input, options.team + ": " + why);
  }
  return std::vector<std::string>{options.team};
}

// Prints a line of CSV for a team, or for each of its members.
void print_csv(const TokenOptions& options, const People& one, const std::string& whose,
               const std::string& token) {
  std::vector<std::string> members = one.members;
  std::vector<std::string> mails = parts_of(said_of(one, "mail"));
  if (!options.per_member) members.assign(1, system::joined(members, "; "));
  if (!options.per_member) mails.assign(1, said_of(one, "mail"));
  members.resize(std::max(members.size(), mails.size()));
  mails.resize(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    std::string line = system::csv_line({whose, one.display, token, members[i], mails[i]});
    std::erase(line, '\r');
    std::cout << line;
  }
}

void print(const TokenOptions& options, const PeopleOfTeams& people, const std::string& whose,
           const std::string& token) {
  const auto known = people.find(whose);
  if (options.csv) {
    print_csv(options, known != people.end() ? known->second : People{}, whose, token);
  } else {
    std::cout << (options.all ? whose + ' ' : "") << token << '\n';
  }
}

Result<int> run_token(const TokenOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  const Role role = options.staff       ? Role::staff
                    : options.tutor     ? Role::tutor
                    : options.assistant ? Role::assistant
                                        : Role::team;
  if (int{options.all} + int{options.staff} + int{options.tutor} + int{options.assistant} +
          int{!options.team.empty()} !=
      1)
    return fail(Errc::input, "one of TEAM, --all, --staff, --assistant and --tutor is expected");
  if (!options.person.empty() && role == Role::team)
    return fail(Errc::input, "--name is for a token of --staff, --assistant or --tutor");
  if (const std::string why = objection_to_person(options.person); !why.empty())
    return fail(Errc::input, why);
  if (options.revoke && options.all)
    return fail(Errc::input, "--revoke needs the name of a team, --staff, --assistant or --tutor");
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  const std::string now = utc_text(system::now_s());
  MIROCUP_TRY(const auto expires, expiry_of(options.expires, store.state().file, now));
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  MIROCUP_TRY(auto list, read_tokens(disk, folder));
  MIROCUP_TRY(auto people, read_people(disk, folder));
  if (options.csv) MIROCUP_TRY_VOID(spare_class_list(disk, folder, "/proc/self/fd/1"));

  std::vector<std::pair<std::string, std::string>> made;  // whose, token
  int revoked = 0;
  if (options.revoke) {
    revoked = list.revoke(role, options.team, options.person, now);
  } else if (role != Role::team) {
    made.emplace_back(to_string(role), list.add_for(role, options.person, now, expires));
  } else {
    MIROCUP_TRY(const auto teams, teams_of(options, store.state(), people, list, now));
    const std::size_t known = people.size();
    for (const std::string& team : teams) {
      made.emplace_back(team, list.add(team, now, expires));
      // Whoever has a token is known, also before the first hand-in.
      if (!store.state().find_team(team)) people.try_emplace(team);
    }
    if (people.size() > known) {
      MIROCUP_TRY_VOID(write_people(disk, folder, people));
      std::cerr << "mirocup: " << teams.front() << " is new to the league\n";
    }
  }
  MIROCUP_TRY_VOID(write_tokens(disk, folder, list));
  if (options.revoke) {
    std::cout << (role == Role::team ? options.team : std::string(to_string(role))) << ": "
              << revoked << (revoked == 1 ? " token was" : " tokens were") << " revoked\n";
    return exit_yes;
  }
  // Only what is on disk is shown.
  if (options.csv) std::cout << "team,display,token,members,mail\n";
  for (const auto& [whose, token] : made) print(options, people, whose, token);
  if (options.all && made.empty()) std::cerr << "mirocup: every team has a token already\n";
  return exit_yes;
}

}  // namespace

void add_token(system::Commands& commands) {
  const auto [command, o] = add_command(
      commands, run_token, "token", to_take,
      "Make a token by which a team hands in, and print it once",
      {"mirocup league token spring alpha", "mirocup league token spring --all --csv >tokens.csv"});
  command.option("TEAM", o.team, "Name of the team; it may be new to the league");
  command.flag("--all", o.all, "Make a token for each team of the league that has none");
  command.flag("--staff", o.staff, "Make a token for the staff, who read all hand-ins and decide");
  command.flag("--tutor", o.tutor,
               "Make a token for a tutor, who reads the same as the staff and decides nothing");
  command.flag("--assistant", o.assistant,
               "Make a token for an assistant, who decides and does not see the grades");
  command.option("--name NAME", o.person,
                 "Name of the person who gets such a token: decisions are signed by it, and "
                 "--revoke ends its tokens only");
  const system::Option csv =
      command.flag("--csv", o.csv,
                   "Print lines of team, display name, token, members and mail, for a mail merge");
  command.flag("--per-member", o.per_member, "Print a line for each member of a team").needs(csv);
  const system::Option expires = command.option(
      "--expires TIME", o.expires,
      "Time when the token ends, as for freeze --at, or the last day (in UTC) on which "
      "it is valid");
  command.flag("--revoke", o.revoke, "Make no token, and end all tokens of the team")
      .excludes(expires);
}

}  // namespace mirocup::league
