// SPDX-License-Identifier: MIT
//
// mirocup league check-hand-in, which serve starts for each check.
#include "programs/league/commands.hpp"
#include "tournaments/handin/check_runner.hpp"

namespace mirocup::league {

namespace {

struct CheckHandInOptions {
  std::string folder;
  std::string team;
  int entry = 0;
  std::string file;
  std::int64_t at = 0;       // s since 1970
  int compile_seconds = 60;  // of processor time, for a source
  std::string answer;        // file for the answer
};

Result<int> run_check_hand_in(const CheckHandInOptions& options) {
  system::Disk disk;
  return record::answering(options.answer, [&](const auto& answer) {
    return check_hand_in(disk, Folder{options.folder}, options.team, options.entry, options.file,
                         options.at, options.compile_seconds, answer);
  });
}

}  // namespace

void add_check_hand_in(system::Commands& commands) {
  const auto [command, o] = commands.add(run_check_hand_in, "check-hand-in", "",
                                         "Check a hand-in, as a child of serve --hand-in", {});
  add_folder(command, o.folder);
  command.option("TEAM", o.team).required();
  command.option("ENTRY", o.entry).required();
  command.option("--file", o.file).required();
  command.option("--at", o.at).required();
  command.option("--compile-seconds", o.compile_seconds).required();
  command.option("--answer", o.answer).required();
}

}  // namespace mirocup::league
