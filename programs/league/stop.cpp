// SPDX-License-Identifier: MIT
//
// mirocup league stop: stops a league that is being played.
#include "programs/league/commands.hpp"
#include "system/file_lock.hpp"
#include "tournaments/league/folder.hpp"

#include <csignal>
#include <iostream>
#include <vector>

namespace mirocup::league {

namespace {

struct StopOptions {
  std::string folder;
  bool now = false;
};

// Asks the process that plays the league to stop. The lock on the file tells whether there is one.
Result<int> run_stop(const StopOptions& options) {
  const Folder folder{options.folder};
  system::Disk disk;
  MIROCUP_TRY_VOID(expect_league(disk, folder));
  // A second SIGINT could merge with the first, so the second request is another signal.
  std::vector<int> signals{SIGINT};
  if (options.now) signals.push_back(SIGTERM);
  MIROCUP_TRY(const auto asked, system::FileLock::signal_holder(folder.running(), signals));
  if (!asked) {
    std::cout << folder.path << " is not being played\n";
    return exit_no;
  }
  std::cout << folder.path
            << (options.now ? " stops\n" : " stops when its present legs are over\n");
  return exit_yes;
}

}  // namespace

void add_stop(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_stop, "stop", to_play, "Stop a league that is being played",
                   {"mirocup league stop spring"});
  add_folder(command, o.folder);
  command.flag("--now", o.now, "Also stop the present legs, instead of playing them to their end");
}

}  // namespace mirocup::league
