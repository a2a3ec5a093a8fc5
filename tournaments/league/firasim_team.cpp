// SPDX-License-Identifier: MIT
#include "tournaments/league/firasim_team.hpp"

#include "system/file_lock.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/league/submission.hpp"

namespace mirocup::league {

Result<std::string> enter_firasim_team(system::Files& files, const Folder& folder,
                                       const TeamConfig& team, std::int64_t now) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.submitting()));
  MIROCUP_TRY(const auto store, LeagueStore::open(files, folder));
  LeagueFile file = store.state().file;
  if (store.state().is_started) return "the league has started, so its programs stay as they are";
  const auto known = store.state().find_team(team.name);
  if (known && !file.teams[*known].is_firasim())
    return "the league has a team of that name, which plays with " + file.teams[*known].source;
  if (!known) {
    if (const std::string why = why_not_now(store.state(), team.name, utc_text(now)); !why.empty())
      return why;
    file.teams.push_back(team);
  } else {
    file.teams[*known] = team;
  }
  // Parsed first, because the parser checks names.
  const std::string text = print_league_file(file);
  MIROCUP_TRY_VOID(parse_league_file(text, folder.config()));
  MIROCUP_TRY_VOID(files.write(folder.config(), text));
  return "";
}

}  // namespace mirocup::league
