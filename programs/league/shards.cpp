// SPDX-License-Identifier: MIT
//
// The subcommands for many computers: plan books what shards have played and lists what may be
// played; run-shard plays fixtures on any machine, and only writes records.
#include "programs/league/commands.hpp"
#include "record/kept_module.hpp"
#include "tournaments/play/program.hpp"
#include "tournaments/play/result_recorder.hpp"
#include "tournaments/play/shard.hpp"

namespace mirocup::league {

namespace {

// The records of shards are booked first, because they may open the next round.
Result<int> run_plan(system::Files& files, LeagueStore& store, const LeagueOptions&) {
  MIROCUP_TRY_VOID(expect_program(store, record::this_software()));
  MIROCUP_TRY_VOID(record::keep_module(files, store.folder().path));
  const auto progress = make_progress_reporter();
  ResultRecorder recorder(files, std::move(store), *progress);
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

struct ShardOptions : LeagueOptions {
  std::vector<std::string> fixtures;
};

Result<int> run_shards(system::Files& files, const LeagueStore& store,
                       const ShardOptions& options) {
  MIROCUP_TRY(const auto failed, play_shards(files, store, options.fixtures));
  if (failed == 0) return exit_yes;
  return fail(Errc::host,
              std::to_string(failed) + " legs could not be played; run the same command again");
}

}  // namespace

void add_plan(system::Commands& commands) {
  add_command(commands, on_own_league<run_plan>, "plan", on_clusters,
              "Start the league, book the records of shards, and list the fixtures to play",
              {"mirocup league plan spring"});
}

void add_run_shard(system::Commands& commands) {
  const auto [command, o] = add_command(
      commands, on_league<run_shards, ShardOptions>, "run-shard", on_clusters,
      "Play fixtures on any machine and write only their records, which league start books",
      {"mirocup league run-shard spring r1-f1 r1-f2"});
  command.option("FIXTURE", o.fixtures, "Ids of fixtures, as league plan lists them").required();
}

}  // namespace mirocup::league
