// SPDX-License-Identifier: MIT
//
// mirocup league backup: copies a league, also while it is played.
#include "tournaments/play/backup.hpp"

#include "programs/league/commands.hpp"
#include "tournaments/league/league_store.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct BackupOptions {
  std::string folder;
  std::string to;
};

Result<int> run_backup(const BackupOptions& options) {
  system::Disk disk;
  // Is it a league?
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto done, back_up(disk, Folder{options.folder}, Folder{options.to}));
  std::cout << options.to << ": " << done.copied << " files copied, " << done.known
            << " records were in the copy already\n";
  return exit_yes;
}

}  // namespace

void add_backup(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_backup, "backup", to_play, "Copy the league; it may be played meanwhile",
                   {"mirocup league backup spring /backup/spring"});
  add_folder(command, o.folder);
  command.option("TO", o.to, "Folder to copy to: a new one, or one with an earlier copy")
      .required()
      .checked("DIR", problem_with_folder);
}

}  // namespace mirocup::league
