// SPDX-License-Identifier: MIT
//
// mirocup league stats, which mirocup stats starts for a league.
#include "programs/league/commands.hpp"
#include "record/statistics/report.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/publish/league_statistics.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct StatsOptions : statistics::ReportOptions {
  std::string folder;
};

Result<int> run_stats(const StatsOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto legs, all_statistics(disk, store.folder(), store.state()));
  MIROCUP_TRY(const auto text, statistics::report(legs, options));
  std::cout << text;
  return exit_yes;
}

}  // namespace

void add_stats(system::Commands& commands) {
  const auto [command, o] = commands.add(run_stats, "stats", to_show,
                                         "Print the football statistics of all legs that count",
                                         {"mirocup league stats spring --csv"});
  add_folder(command, o.folder);
  command.flag(
      "--goals", o.goals,
      "Print how goals fell, where the ball was lost before each goal, and which laws were broken");
  command.option("--team", o.team, "Only the legs of this team");
  const system::Option csv = command.flag("--csv", o.csv, "Print comma-separated values");
  command.flag("--json", o.json, "Print everything as one JSON object").excludes(csv);
}

}  // namespace mirocup::league
