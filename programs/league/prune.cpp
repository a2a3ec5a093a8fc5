// SPDX-License-Identifier: MIT
//
// mirocup league prune: makes room by removing the replay pages of former nights.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "system/memory.hpp"
#include "tournaments/league/health.hpp"
#include "tournaments/league/league_store.hpp"

#include <iostream>

namespace mirocup::league {

namespace {

struct PruneOptions {
  std::string folder;
  int before = 0;  // the first night that keeps its pages
};

// The last night keeps its pages: digests and mails link to them. What is removed is noted first,
// so that a command that is killed is finished by the next one that makes pages.
Result<int> run_prune(const PruneOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  system::Disk disk;
  const Folder folder{options.folder};
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, folder));
  const LeagueState& state = store.state();
  const int last = static_cast<int>(state.nights.size());
  if (state.file.format.kind != FormatKind::nightly)
    return fail(Errc::input,
                folder.path + " has no nights: only leagues of the format nightly have nights");
  if (options.before > last)
    return fail(Errc::input, "--before " + std::to_string(options.before) +
                                 ": the last night keeps its pages, so at most " +
                                 std::to_string(last) + " is possible");
  MIROCUP_TRY(const auto found, gaps(disk, store, is_being_played(folder)));
  if (!found.lost.empty()) return fail(Errc::damaged, found.lost);
  std::set<int> nights = state.pruned_nights;
  for (int night = 1; night < options.before; ++night) nights.insert(night);
  const DiskUse before = disk_use(store.folder());
  MIROCUP_TRY_VOID(write_pruned_nights(disk, folder, nights));
  MIROCUP_TRY(const int published, publish_league(disk, folder));
  const DiskUse after = disk_use(store.folder());
  std::cout << folder.path << ": pages of " << nights.size()
            << (nights.size() == 1 ? " night" : " nights") << " are removed, "
            << system::mebibytes(before.pages - std::min(before.pages, after.pages))
            << " freed; records and replay files stay\ndisk: " << in_words(after) << '\n';
  return published;
}

}  // namespace

void add_prune(system::Commands& commands) {
  const auto [command, o] = commands.add(run_prune, "prune", to_show,
                                         "Remove the replay pages of former nights, to make room",
                                         {"mirocup league prune spring --before 12"});
  add_folder(command, o.folder);
  command
      .option("--before", o.before,
              "Nights before this one lose their pages; mirocup league publish --pages makes the "
              "pages of a night again")
      .named("NIGHT")
      .between(2, max_count)
      .required();
}

}  // namespace mirocup::league
