// SPDX-License-Identifier: MIT
//
// mirocup league run-shard: plays fixtures on any machine, and only writes records.
#include "programs/league/commands.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/play/shard.hpp"

namespace mirocup::league {

namespace {

struct ShardOptions {
  std::string folder;
  std::vector<std::string> fixtures;
};

Result<int> run_shards(const ShardOptions& options) {
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  MIROCUP_TRY(const auto failed, play_shards(disk, store, options.fixtures));
  if (failed == 0) return exit_yes;
  return fail(Errc::host,
              std::to_string(failed) + " legs could not be played; run the same command again");
}

}  // namespace

void add_run_shard(system::Commands& commands) {
  const auto [command, o] = commands.add(
      run_shards, "run-shard", on_clusters,
      "Play fixtures on any machine and write only their records, which league start books",
      {"mirocup league run-shard spring r1-f1 r1-f2"});
  add_folder(command, o.folder);
  command.option("FIXTURE", o.fixtures, "Ids of fixtures, as league plan lists them").required();
}

}  // namespace mirocup::league
