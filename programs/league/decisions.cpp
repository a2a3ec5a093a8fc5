// SPDX-License-Identifier: MIT
//
// mirocup league decisions: what the staff has decided.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "system/printable.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/exports.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct DecisionsOptions {
  std::string folder;
  bool json = false;
};

Result<int> run_decisions(const DecisionsOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY_VOID(say_gaps(disk, store));
  const LeagueState& state = store.state();
  if (options.json) {
    std::cout << decisions_json(state) << '\n';
    return exit_yes;
  }
  for (const DecisionView& d : decision_views(state)) {
    std::cout << d.number << "  " << shown_time(state.file, d.at) << "  "
              << (d.by.empty() ? "-" : system::printable(d.by)) << "  " << system::printable(d.what)
              << "  \"" << system::printable(d.why) << '"'
              << (d.undoing.empty() ? "" : "  [" + d.undoing + "]") << '\n';
  }
  return exit_yes;
}

}  // namespace

void add_decisions(system::Commands& commands) {
  const auto [command, o] = commands.add(run_decisions, "decisions", to_rule,
                                         "List the decisions: number, time, person, what and why",
                                         {"mirocup league decisions spring"});
  add_folder(command, o.folder);
  command.flag("--json", o.json, "Print one JSON object");
}

}  // namespace mirocup::league
