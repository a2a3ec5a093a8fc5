// SPDX-License-Identifier: MIT
//
// `mirocup league credentials`: makes the DDS credentials of the processes of a league. It collects
// the names of the teams; credentials.sh makes the files with openssl.
#include "server/record/match_record.hpp"
#include "server/system/child_process.hpp"
#include "server/system/locations.hpp"
#include "tournaments/app/commands.hpp"
#include "tournaments/league/folder.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

// Returns the teams of the league in the folder, if there is one, and those of the command line.
Result<std::vector<std::string>> teams_of(const CredentialsOptions& options) {
  std::vector<std::string> names = options.teams;
  system::Disk disk;
  const std::string config = Folder{options.folder}.config();
  if (!disk.exists(config)) {
    if (!names.empty() || !options.revoked.empty()) return names;
    return fail(Errc::input, options.folder + " holds no league, and --team names nobody");
  }
  const auto text = disk.read(config);
  if (!text) return tl::unexpected(text.error());
  const auto league = parse_league_file(*text, config);
  if (!league) return tl::unexpected(league.error());
  for (const TeamConfig& team : league->teams) names.push_back(team.name);
  return names;
}

Result<void> run_script(std::vector<std::string> arguments) {
  const auto code = system::run_child({.arguments = arguments, .cpu = -1, .log = ""});
  if (!code || *code == system::not_found) {
    return fail(Errc::unavailable, arguments[0] + " cannot be run");
  }
  if (*code == 0) return {};
  return fail(Errc::unavailable, "the credentials could not be made; see above");
}

}  // namespace

Result<int> run_credentials(const CredentialsOptions& options) {
  const auto teams = teams_of(options);
  if (!teams) return tl::unexpected(teams.error());
  system::Disk disk;
  const std::string folder = Folder{options.folder}.credentials();
  if (auto made = disk.make_folder(folder); !made) return tl::unexpected(made.error());
  std::vector<std::string> arguments{system::sibling_program("mirocup-credentials"), folder,
                                     std::to_string(options.days)};
  const auto is_revoked = [&options](const std::string& team) {
    return std::find(options.revoked.begin(), options.revoked.end(), team) != options.revoked.end();
  };
  for (const std::string& team : *teams) {
    if (!is_revoked(team)) arguments.insert(arguments.end(), {"team", team});
  }
  for (const std::string& team : options.revoked) {
    arguments.insert(arguments.end(), {"revoke", team});
  }
  if (auto done = run_script(std::move(arguments)); !done) return tl::unexpected(done.error());
  return exit_yes;
}

}  // namespace mirocup::league
