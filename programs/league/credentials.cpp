// SPDX-License-Identifier: MIT
//
// The subcommand credentials. credentials/credentials.sh makes the certificates with openssl; this
// source determines the teams.
#include "programs/league/commands.hpp"
#include "record/match_record.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

struct CredentialsOptions : LeagueOptions {
  std::vector<std::string> teams;
  std::vector<std::string> revoked;
  int days = 365;
};

// Returns the teams of the command line and those of the league in the folder, if there is one.
Result<std::vector<std::string>> teams_of(const CredentialsOptions& options) {
  std::vector<std::string> names = options.teams;
  system::Disk disk;
  const std::string config = Folder{options.folder}.config();
  if (!disk.exists(config)) {
    if (!names.empty() || !options.revoked.empty()) return names;
    return fail(Errc::input,
                options.folder + " is not a league's folder, so name the teams by --team");
  }
  MIROCUP_TRY(const auto text, disk.read_named(config, system::size_limit::league_file));
  MIROCUP_TRY(const auto league, parse_league_file(text, config));
  for (const TeamConfig& team : league.teams) names.push_back(team.name);
  return names;
}

// A team's name must fit the topic Hello, and becomes the name of a folder.
constexpr std::size_t max_name = 64;  // bytes

Result<void> check_name(const std::string& option, const std::string& name) {
  const auto bad = [&](const std::string& why) {
    return fail(Errc::input, option + ": a team's name " + why);
  };
  if (name.empty()) return bad("must not be empty");
  if (name == "." || name == "..") return bad("must not be \".\" or \"..\"");
  if (name.size() > max_name)
    return bad("has at most " + std::to_string(max_name) + " bytes, this one has " +
               std::to_string(name.size()));
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  if (std::ranges::any_of(name, is_control)) return bad("must not have control characters");
  return {};
}

Result<void> run_script(std::vector<std::string> arguments) {
  const auto code = system::run_child({.arguments = arguments, .cpu = -1, .log = ""});
  if (!code || *code == system::not_found) {
    return fail(Errc::unavailable, arguments[0] + " cannot be run");
  }
  if (*code == 0) return {};
  return fail(Errc::unavailable, "the credentials could not be made; see above");
}

Result<int> run_credentials(const CredentialsOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  for (const std::string& name : options.teams) MIROCUP_TRY_VOID(check_name("--team", name));
  for (const std::string& name : options.revoked) MIROCUP_TRY_VOID(check_name("--revoke", name));
  MIROCUP_TRY(const auto teams, teams_of(options));
  system::Disk disk;
  const std::string folder = Folder{options.folder}.credentials();
  MIROCUP_TRY_VOID(disk.make_folder(folder));
  std::vector<std::string> arguments{system::sibling_program("mirocup-credentials"), folder,
                                     std::to_string(options.days)};
  for (const std::string& team : teams) {
    if (std::ranges::count(options.revoked, team) == 0)
      arguments.insert(arguments.end(), {"team", team});
  }
  for (const std::string& team : options.revoked)
    arguments.insert(arguments.end(), {"revoke", team});
  MIROCUP_TRY_VOID(run_script(std::move(arguments)));
  return exit_yes;
}

}  // namespace

void add_credentials(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, run_credentials, "credentials", to_make,
                  "Make the certificates of teams, match server and spectators for DDS Security",
                  {"mirocup league credentials spring"});
  command.option("--team NAME", o.teams, "Further team, which league.json does not have");
  command.option("--revoke TEAM", o.revoked, "Team whose credentials become invalid");
  command.option("--days DAYS", o.days, "Number of days for which new credentials are valid")
      .between(1, 3650)
      .shows_default();
}

}  // namespace mirocup::league
