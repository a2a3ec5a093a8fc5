// SPDX-License-Identifier: MIT
//
// mirocup stats RECORD…|LEAGUE: football statistics. Records are played again here; the legs of a
// league are known to mirocup-league only.
#include "programs/mirocup/commands.hpp"
#include "record/statistics/report.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"

#include <filesystem>

namespace mirocup::app {

namespace {

struct StatsOptions : statistics::ReportOptions {
  std::vector<std::string> paths;  // records, or the folder of a league
};

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

Result<int> become_league_program(const StatsOptions& options) {
  std::vector<std::string> arguments{system::sibling_program("mirocup-league"), "stats",
                                     options.paths.front()};
  if (!options.team.empty()) arguments.insert(arguments.end(), {"--team", options.team});
  if (options.goals) arguments.emplace_back("--goals");
  if (options.csv) arguments.emplace_back("--csv");
  if (options.json) arguments.emplace_back("--json");
  return tl::unexpected(system::become_program(std::move(arguments)));
}

Result<int> run_stats(const StatsOptions& options) {
  if (options.paths.size() == 1 && is_folder(options.paths.front())) {
    return become_league_program(options);
  }
  for (const std::string& path : options.paths) {
    if (is_folder(path)) {
      return fail(Errc::input,
                  path + ": is a folder; name one league alone, or records without a league");
    }
  }
  system::Disk disk;
  MIROCUP_TRY(const auto legs, statistics::count_records(disk, options.paths));
  MIROCUP_TRY(const auto text, statistics::report(legs, options));
  std::cout << text;
  int result = exit_yes;
  for (const statistics::LegReport& leg : legs) {
    if (!leg.differs) continue;
    std::cerr << "mirocup: " << system::printable(leg.record) << ": its result differs from its "
              << "replay at tick " << leg.differs->tick << ": "
              << system::printable(leg.differs->what) << '\n';
    result = exit_no;
  }
  return result;
}

}  // namespace

void add_stats(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_stats, "stats", after_a_leg,
      "Print the football statistics of legs: shots, passes, possession, fouls, goals by kind",
      {"mirocup stats leg.json --goals", "mirocup stats spring --csv"});
  command.option("RECORD", o.paths, "Match records, or the folder of one league").required();
  statistics::add_options(command, o, "Only the legs of this team, named as in the records");
}

}  // namespace mirocup::app
