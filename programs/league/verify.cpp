// SPDX-License-Identifier: MIT
//
// mirocup league verify: simulates all records again.
#include "programs/league/commands.hpp"
#include "record/json_reader.hpp"
#include "record/kept_module.hpp"
#include "system/printable.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/play/program.hpp"

#include <algorithm>
#include <iostream>

namespace mirocup::league {

namespace {

struct VerifyOptions {
  std::string folder;
  int jobs = 0;  // records at once; 0: one for each processor
  bool trusts_programs = false;
  bool json = false;
};

Result<int> run_verify_league(const VerifyOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  if (options.trusts_programs) {
    MIROCUP_TRY(const auto trusted, record::trust_modules(disk, options.folder));
    for (const std::string& path : trusted)
      std::cerr << "mirocup: " << system::printable(path) << " is trusted from now on\n";
  }
  MIROCUP_TRY(const auto done, verify_records(disk, store, options.jobs));
  int result = exit_yes;
  for (const auto& problem : done.problems) result = std::max(result, problem.code);
  if (options.json) {
    Json problems = Json::array();
    for (const auto& p : done.problems)
      problems.push_back({{"record", p.record}, {"code", p.code}, {"what", p.text}});
    std::cout << record::json_text({{"records", done.records},
                                    {"reproduced", done.reproduced},
                                    {"problems", problems}})
              << '\n';
    return result;
  }
  for (const auto& problem : done.problems)
    std::cout << system::printable(problem.record) << ": " << system::printable(problem.text)
              << '\n';
  std::cout << done.reproduced << " of " << done.records << " records reproduced\n";
  return result;
}

}  // namespace

void add_verify(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_verify_league, "verify", to_play, "Simulate all records again",
      {"mirocup league verify spring", "mirocup league verify copied --trust-programs"});
  add_folder(command, o.folder);
  command.jobs(o.jobs, "records simulated");
  command.flag("--trust-programs", o.trusts_programs,
               "Trust the browser modules in the league's folder from now on: they verify records "
               "of other versions. Give this option only if you know where they come from");
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::league
