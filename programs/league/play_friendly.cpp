// SPDX-License-Identifier: MIT
//
// The subcommand play-friendly: becomes the match of one friendly, or the drills of an
// entry, at a low priority.
#include "programs/league/commands.hpp"
#include "system/locations.hpp"
#include "tournaments/league/friendly.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/play/leg_command.hpp"

#include <cerrno>
#include <cstring>
#include <sys/resource.h>
#include <unistd.h>

namespace mirocup::league {

namespace {

struct PlayFriendlyOptions {
  std::string folder;
  std::string team;
  int number = 0;  // 0: the drills
  int entry = 0;
  std::string opponent;  // a team, or "house:NAME"
  int opponent_entry = 0;
};

constexpr int priority_of_friendlies = 15;  // checks, pages and matches come first

Result<int> run_play_friendly(const PlayFriendlyOptions& options) {
  setpriority(PRIO_PROCESS, 0, priority_of_friendlies);
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  FriendlyTerms terms;
  terms.blue = {folder.library(options.team, options.entry), options.team};
  const std::string& opponent = options.opponent;
  const std::string name = opponent.substr(opponent.find(':') + 1);
  terms.yellow = is_house(opponent)
                     ? FriendlyTerms::Side{system::house_team(name), name}
                     : FriendlyTerms::Side{folder.library(opponent, options.opponent_entry), name};
  terms.seed = static_cast<std::uint64_t>(options.number);
  terms.record = folder.friendly(options.team, options.number);
  const std::vector<std::string> command =
      options.number == 0
          ? drills_command(store.state(), terms.blue,
                           folder.drill_marks(options.team, options.entry) + ".answer")
          : friendly_command(store.state(), terms);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(words[0], words.data());
  return fail(Errc::host, command[0] + ": " + std::strerror(errno));
}

}  // namespace

void add_play_friendly(system::Commands& commands) {
  const auto [command, o] = commands.add(run_play_friendly, "play-friendly", "",
                                         "Play a friendly, as a child of serve --hand-in", {});
  add_folder(command, o.folder);
  command.option("TEAM", o.team).required();
  command.option("NUMBER", o.number).required();
  command.option("--entry", o.entry).required();
  command.option("--opponent", o.opponent).required();
  command.option("--opponent-entry", o.opponent_entry).required();
}

}  // namespace mirocup::league
