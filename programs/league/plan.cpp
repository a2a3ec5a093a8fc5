// SPDX-License-Identifier: MIT
//
// mirocup league plan: books what shards have played, and lists what may be played.
#include "programs/league/commands.hpp"
#include "programs/league/progress_bar.hpp"
#include "record/kept_module.hpp"
#include "tournaments/play/program.hpp"
#include "tournaments/play/result_recorder.hpp"
#include "tournaments/play/shard.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct PlanOptions {
  std::string folder;
};

// The records of shards are booked first, because they may open the next round.
Result<int> run_plan(const PlanOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  system::Disk disk;
  MIROCUP_TRY(auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY_VOID(expect_program(store, record::this_software()));
  MIROCUP_TRY_VOID(record::keep_module(disk, store.folder().path));
  const auto progress = make_progress_reporter();
  ResultRecorder recorder(disk, std::move(store), *progress);
  MIROCUP_TRY_VOID(recorder.start());
  for (int booked = 1; booked > 0;) {
    booked = 0;
    for (const std::string& id : open_shards(recorder.state())) {
      MIROCUP_TRY(const auto count, recorder.book_played(id));
      booked += count;
    }
  }
  for (const std::string& id : open_shards(recorder.state())) std::cout << id << '\n';
  return recorder.refused() == 0 ? exit_yes : exit_no;
}

}  // namespace

void add_plan(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_plan, "plan", on_clusters,
                   "Start the league, book the records of shards, and list the fixtures to play",
                   {"mirocup league plan spring"});
  add_folder(command, o.folder);
}

}  // namespace mirocup::league
