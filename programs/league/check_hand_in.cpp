// SPDX-License-Identifier: MIT
//
// mirocup league check-hand-in, which serve starts for each check: checks a hand-in at a low
// priority, and leaves its verdict beside it.
#include "programs/league/commands.hpp"
#include "tournaments/league/submission.hpp"

#include <sys/resource.h>

namespace mirocup::league {

namespace {

struct CheckHandInOptions : LeagueOptions {
  std::string team;
  int entry = 0;
  std::string file;
  int compile_seconds = 60;  // of processor time, for a source
};

constexpr int priority_of_checks = 10;  // pages and matches come first

Result<int> run_check_hand_in(const CheckHandInOptions& options) {
  setpriority(PRIO_PROCESS, 0, priority_of_checks);
  system::Disk disk;
  const HandedIn handed{
      .team = options.team, .entry = options.entry, .file = options.file, .is_network = true};
  MIROCUP_TRY(const auto verdict,
              check_entry(disk, Folder{options.folder}, handed, options.compile_seconds));
  return verdict["accepted"] == true ? exit_yes : exit_no;
}

}  // namespace

void add_check_hand_in(system::Commands& commands) {
  const auto [command, o] = add_command(commands, run_check_hand_in, "check-hand-in", "",
                                        "Check a hand-in, as a child of serve --hand-in", {});
  command.option("TEAM", o.team).required();
  command.option("ENTRY", o.entry).required();
  command.option("--file", o.file).required();
  command.option("--compile-seconds", o.compile_seconds).required();
}

}  // namespace mirocup::league
