// SPDX-License-Identifier: MIT
//
// mirocup league health: whether a person has to look at the league.
#include "tournaments/league/health.hpp"

#include "programs/league/commands.hpp"
#include "record/json_reader.hpp"
#include "system/clock.hpp"
#include "system/printable.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct HealthOptions {
  std::string folder;
  bool json = false;
};

Json health_json(const LeagueState& state, const Health& h, const DiskUse& disk) {
  const Json night{{"number", h.night}, {"at", h.night_at}};
  return {{"title", state.file.title},
          {"needs_person", !h.problems.empty()},
          {"problems", h.problems},
          {"night", h.night > 0 ? night : Json()},
          {"playing", h.is_playing},
          {"open_legs", h.open_legs},
          {"hand_ins", {{"waiting", h.waiting}, {"longest_s", h.waits_s}}},
          {"disk", disk_json(disk)}};
}

Result<int> run_health(const HealthOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto h, health(disk, store, system::now_s()));
  const DiskUse use = disk_use(store.folder());
  if (options.json) {
    std::cout << record::json_text(health_json(store.state(), h, use)) << '\n';
    return h.problems.empty() ? exit_yes : exit_no;
  }
  const LeagueFile& file = store.state().file;
  std::cout << system::printable(file.title) << ": ";
  if (h.night == 0) std::cout << "no night yet";
  if (h.night > 0) std::cout << "night " << h.night << " began at " << shown_time(file, h.night_at);
  std::cout << (h.is_playing ? ", the league is being played" : "")
            << "; legs that are not decided: " << h.open_legs
            << "\nhand-ins that wait for their checks: " << h.waiting << "\ndisk: " << in_words(use)
            << '\n';
  for (const std::string& problem : h.problems)
    std::cout << "for you: " << system::printable(problem) << '\n';
  return h.problems.empty() ? exit_yes : exit_no;
}

}  // namespace

void add_health(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_health, "health", to_play,
      "Print the state of nights, hand-ins and disk (exit code 1: the league needs a person)",
      {"mirocup league health spring || mail -s spring lecturer@example.org"});
  add_folder(command, o.folder);
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::league
