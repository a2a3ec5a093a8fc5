// SPDX-License-Identifier: MIT
//
// The subcommands that keep what was played: verify simulates all records again, backup copies a
// league, also while it is played.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "record/kept_module.hpp"
#include "tournaments/play/backup.hpp"
#include "tournaments/play/program.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

struct VerifyOptions : LeagueOptions {
  int jobs = 0;  // records at once; 0: one for each processor
  bool trusts_programs = false;
  bool json = false;
};

Result<int> run_verify_league(system::Files& files, const LeagueStore& store,
                              const VerifyOptions& options) {
  if (options.trusts_programs) {
    MIROCUP_TRY(const auto trusted, record::trust_modules(files, options.folder));
    for (const std::string& path : trusted)
      std::cerr << "mirocup: " << system::printable(path) << " is trusted from now on\n";
  }
  MIROCUP_TRY(const auto done, verify_records(files, store, options.jobs));
  int result = exit_yes;
  for (const auto& problem : done.problems) result = std::max(result, problem.code);
  if (options.json) {
    Json problems = Json::array();
    for (const auto& p : done.problems)
      problems.push_back({{"record", p.record}, {"code", p.code}, {"what", p.text}});
    print_json(
        {{"records", done.records}, {"reproduced", done.reproduced}, {"problems", problems}});
    return result;
  }
  for (const auto& problem : done.problems)
    std::cout << system::printable(problem.record) << ": " << system::printable(problem.text)
              << '\n';
  std::cout << done.reproduced << " of " << done.records << " records reproduced\n";
  return result;
}

struct BackupOptions : LeagueOptions {
  std::string to;
};

Result<int> run_backup(system::Files& files, const LeagueStore& store,
                       const BackupOptions& options) {
  MIROCUP_TRY(const auto found, say_gaps(files, store));
  MIROCUP_TRY(const auto done, back_up(files, store.folder(), Folder{options.to}));
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

void add_verify(system::Commands& commands) {
  const auto [command, o] = add_command(
      commands, on_league<run_verify_league, VerifyOptions>, "verify", to_play,
      "Simulate all records again",
      {"mirocup league verify spring", "mirocup league verify copied --trust-programs"});
  command.jobs(o.jobs, "records simulated");
  command.flag("--trust-programs", o.trusts_programs,
               "Trust the browser modules in the league's folder from now on: they verify records "
               "of other versions. Give this option only if you know where they come from");
  command.flag("--json", o.json, "Print one JSON object");
}

void add_backup(system::Commands& commands) {
  const auto [command, o] = add_command(commands, on_league<run_backup, BackupOptions>, "backup",
                                        to_play, "Copy the league; it may be played meanwhile",
                                        {"mirocup league backup spring /backup/spring"});
  command.option("TO", o.to, "Folder to copy to: a new one, or one with an earlier copy")
      .required()
      .checked("DIR", problem_with_folder);
}

}  // namespace mirocup::league
