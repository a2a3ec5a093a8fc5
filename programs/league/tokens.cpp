// SPDX-License-Identifier: MIT
//
// The subcommand token.
#include "tournaments/handin/tokens.hpp"

#include "programs/league/commands.hpp"
#include "system/file_lock.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/league/submission.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

// Returns a time as league.json has it; also a day is taken, which means its end.
Result<std::string> expiry_of(const std::string& text, const std::string& now) {
  std::string time = text;
  constexpr std::size_t length_of_day = 10;  // characters
  if (time.size() == length_of_day) time += "T23:59:59Z";
  if (!time.empty() && !is_time(time)) {
    return fail(Errc::input, "--expires " + text +
                                 ": a time in UTC like 2026-12-18T18:00:00Z is expected, or a day");
  }
  if (!time.empty() && time <= now)
    return fail(Errc::input, "--expires " + text + ": that time is over");
  return time;
}

// Returns the teams that are to get a token.
Result<std::vector<std::string>> teams_of(const TokenOptions& options, const LeagueState& state,
                                          const TokenList& list, const std::string& now) {
  std::vector<std::string> teams;
  if (options.all) {
    for (const TeamConfig& team : state.file.teams) {
      if (!list.has_valid(team.name, now)) teams.push_back(team.name);
    }
    return teams;
  }
  if (!is_good_name(options.team)) {
    return fail(Errc::input, "\"" + options.team +
                                 "\" is no name: letters, digits, '-', '_' and '.', at most 40");
  }
  // A team that will join is named here for the first time.
  if (!options.revoke && !state.find_team(options.team)) {
    if (const std::string why = why_not_now(state, options.team, now); !why.empty())
      return fail(Errc::input, options.team + ": " + why);
  }
  return std::vector<std::string>{options.team};
}

void print(const TokenOptions& options, const std::string& whose, const std::string& token) {
  if (options.csv) {
    std::cout << whose << ',' << token << '\n';
  } else if (options.all) {
    std::cout << whose << ' ' << token << '\n';
  } else {
    std::cout << token << '\n';
  }
}

}  // namespace

Result<int> run_token(const TokenOptions& options) {
  const Role role = options.staff ? Role::staff : options.tutor ? Role::tutor : Role::team;
  if (int{options.all} + int{options.staff} + int{options.tutor} + int{!options.team.empty()} != 1)
    return fail(Errc::input, "one of TEAM, --all, --staff and --tutor is expected");
  if (options.revoke && options.all)
    return fail(Errc::input, "--revoke needs the name of a team, --staff or --tutor");
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  const std::string now = utc_text(system::now_s());
  MIROCUP_TRY(const auto expires, expiry_of(options.expires, now));
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  MIROCUP_TRY(auto list, read_tokens(disk, folder));

  std::vector<std::pair<std::string, std::string>> made;  // whose, token
  int revoked = 0;
  if (options.revoke) {
    revoked = list.revoke(role, options.team, now);
  } else if (role != Role::team) {
    made.emplace_back(to_string(role), list.add_for(role, now, expires));
  } else {
    MIROCUP_TRY(const auto teams, teams_of(options, store.state(), list, now));
    for (const std::string& team : teams) made.emplace_back(team, list.add(team, now, expires));
  }
  MIROCUP_TRY_VOID(write_tokens(disk, folder, list));
  if (options.revoke) {
    std::cout << (role == Role::team ? options.team : std::string(to_string(role))) << ": "
              << revoked << (revoked == 1 ? " token was" : " tokens were") << " revoked\n";
    return exit_yes;
  }
  // Only what is on disk is shown.
  if (options.csv) std::cout << "team,token\n";
  for (const auto& [whose, token] : made) print(options, whose, token);
  if (options.all && made.empty()) std::cerr << "mirocup: every team has a token already\n";
  return exit_yes;
}

}  // namespace mirocup::league
