// SPDX-License-Identifier: MIT
//
// The subcommand play-friendly: becomes the match of one friendly, or the drills of an
// entry, at a low priority.
#include "programs/league/commands.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"
#include "tournaments/league/friendly.hpp"
#include "tournaments/play/leg_command.hpp"

#include <sys/resource.h>

namespace mirocup::league {

namespace {

struct PlayFriendlyOptions : LeagueOptions {
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
  return fail(Errc::host, system::become_program(command).what);
}

}  // namespace

void add_play_friendly(system::Commands& commands) {
  const auto [command, o] = add_command(commands, run_play_friendly, "play-friendly", "",
                                        "Play a friendly, as a child of serve --hand-in", {});
  command.option("TEAM", o.team).required();
  command.option("NUMBER", o.number).required();
  command.option("--entry", o.entry).required();
  command.option("--opponent", o.opponent).required();
  command.option("--opponent-entry", o.opponent_entry).required();
}

}  // namespace mirocup::league
