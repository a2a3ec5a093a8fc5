// SPDX-License-Identifier: MIT
//
// mirocup league backup: copies a league, also while it is played.
#include "tournaments/play/backup.hpp"

#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct BackupOptions {
  std::string folder;
  std::string to;
};

Result<int> run_backup(const BackupOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto found, say_gaps(disk, store));
  MIROCUP_TRY(const auto done, back_up(disk, store.folder(), Folder{options.to}));
  std::cout << options.to << ": " << done.copied << " files copied, " << done.known
            << " files of records were in the copy already\n";
  std::vector<std::string> left_out;
  for (const std::string& name : named_files(store.state())) {
    if (!done.names.contains(name)) left_out.push_back(name);
  }
  if (!left_out.empty())
    std::cerr << "mirocup: " << left_out.size()
              << " files that the journal names were not copied: " << listed(left_out) << '\n';
  return found.is_whole() && left_out.empty() ? exit_yes : exit_no;
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
