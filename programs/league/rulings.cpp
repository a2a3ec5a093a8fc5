// SPDX-License-Identifier: MIT
//
// The subcommands for what the staff decides: award, rule, void, withdraw, pause, resume, freeze,
// release, close, undo, and their list, decisions. Each decision is a line of the journal with a
// reason; the lines before it stay. Decisions may be made while the league is being played.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "record/json_reader.hpp"
#include "system/printable.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/publish/decision_view.hpp"
#include "tournaments/publish/exports.hpp"

#include <iostream>

namespace mirocup::league {

Result<int> run_act(const ActOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto lines, perform(disk, store, options.act, system::now_s()));
  for (const std::string& line : lines) std::cout << system::printable(line) << '\n';
  // What is held back must not stay on the pages, and what is released is looked for there.
  const Folder folder{options.folder};
  if (options.act.kind == ActKind::release && !options.act.is_dry_run &&
      disk.exists(folder.site())) {
    MIROCUP_TRY_VOID(publish_league(disk, folder));
  }
  return exit_yes;
}

Result<int> run_decisions(const LeagueOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  const LeagueState& state = store.state();
  if (options.json) {
    std::cout << decisions_json(state) << '\n';
    return exit_yes;
  }
  for (const DecisionView& d : decision_views(state)) {
    std::cout << d.number << "  " << (d.at.empty() ? "-" : shown_time(state.file, d.at)) << "  "
              << (d.by.empty() ? "-" : system::printable(d.by)) << "  " << system::printable(d.what)
              << "  \"" << system::printable(d.why) << '"'
              << (d.undoing.empty() ? "" : "  [" + d.undoing + "]") << '\n';
  }
  return exit_yes;
}

}  // namespace mirocup::league
