// SPDX-License-Identifier: MIT
//
// mirocup league status: the table, and what is left.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "record/json_reader.hpp"
#include "system/printable.hpp"
#include "tournaments/league/health.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/publish/exports.hpp"
#include "tournaments/publish/site.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct StatusOptions {
  std::string folder;
  bool entries = false;
  bool json = false;
};

Result<int> run_status(const StatusOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY_VOID(say_gaps(disk, store));
  const LeagueState& state = store.state();
  if (options.entries) {
    MIROCUP_TRY_VOID(print_roster(disk, store, options.json));
  } else if (options.json) {
    Json json = table_json(overview(state));
    json["disk"] = disk_json(disk_use(store.folder()));
    std::cout << record::json_text(json) << '\n';
  } else {
    std::cout << system::printable(state.file.title) << ": " << state.played() << " of "
              << state.legs() << " legs played\n"
              << table_text(state);
    for (std::size_t i = 0; i < state.teams.size(); ++i) {
      const TeamState& team = state.teams[i];
      if (team.status == TeamStatus::playing) continue;
      std::cout << state.file.teams[i].name
                << (team.status == TeamStatus::paused ? " is paused: " : " has withdrawn: ")
                << system::printable(team.why) << '\n';
    }
    if (const std::string at = last_leg_at(store.journal()); !at.empty())
      std::cout << "the last leg was played at " << shown_time(state.file, at) << '\n';
    std::cout << "disk: " << in_words(disk_use(store.folder())) << '\n';
  }
  return state.played() == state.legs() ? exit_yes : exit_no;
}

}  // namespace

void add_status(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_status, "status", to_play,
                   "Print the table and the state of the league (exit code 1: legs are left)",
                   {"mirocup league status spring", "mirocup league status spring --entries"});
  add_folder(command, o.folder);
  command.flag("--entries", o.entries,
               "Print each team's hand-ins and their answers; this does not change the exit code");
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::league
