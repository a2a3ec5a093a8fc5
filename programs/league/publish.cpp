// SPDX-License-Identifier: MIT
//
// The subcommands publish, which makes the pages, and prune, which makes room by removing the
// replay pages of former nights.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "system/memory.hpp"
#include "tournaments/league/health.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

struct PublishOptions : LeagueOptions {
  int pages = 0;  // the night whose pages were removed and are made again; 0: none
};

// Has the next pages of the league include those of a night again.
Result<void> restore_night(system::Files& files, const LeagueStore& store, int night) {
  std::set<int> nights = store.state().pruned_nights;
  if (nights.erase(night) == 0)
    return fail(Errc::input, "the pages of night " + std::to_string(night) + " were not removed");
  return write_pruned_nights(files, store.folder(), nights);
}

Result<int> run_publish(system::Files& files, const LeagueStore& store,
                        const PublishOptions& options) {
  if (options.pages > 0) MIROCUP_TRY_VOID(restore_night(files, store, options.pages));
  const std::string page = store.folder().site() + "/index.html";
  MIROCUP_TRY(const int published, publish_league(files, store.folder()));
  if (published == exit_yes)
    std::cout << std::filesystem::absolute(page).lexically_normal().string() << '\n';
  return published;
}

struct PruneOptions : LeagueOptions {
  int before = 0;  // the first night that keeps its pages
};

// The last night keeps its pages: digests and mails link to them. What is removed is noted first,
// so that a command that is killed is finished by the next one that makes pages.
Result<int> run_prune(system::Files& files, const LeagueStore& store, const PruneOptions& options) {
  const Folder& folder = store.folder();
  const LeagueState& state = store.state();
  const int last = static_cast<int>(state.nights.size());
  if (state.file.format.kind != FormatKind::nightly)
    return fail(Errc::input,
                folder.path + " has no nights: only leagues of the format nightly have nights");
  if (options.before > last)
    return fail(Errc::input, "--before " + std::to_string(options.before) +
                                 ": the last night keeps its pages, so at most " +
                                 std::to_string(last) + " is possible");
  MIROCUP_TRY(const auto found, gaps(files, store, is_being_played(folder)));
  if (!found.lost.empty()) return fail(Errc::damaged, found.lost);
  std::set<int> nights = state.pruned_nights;
  for (int night = 1; night < options.before; ++night) nights.insert(night);
  const DiskUse before = disk_use(folder);
  MIROCUP_TRY_VOID(write_pruned_nights(files, folder, nights));
  MIROCUP_TRY(const int published, publish_league(files, folder));
  const DiskUse after = disk_use(folder);
  std::cout << folder.path << ": pages of " << nights.size()
            << (nights.size() == 1 ? " night" : " nights") << " are removed, "
            << system::mebibytes(before.pages - std::min(before.pages, after.pages))
            << " freed; records and replay files stay\ndisk: " << in_words(after) << '\n';
  return published;
}

}  // namespace

void add_publish(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, on_own_league<run_publish, PublishOptions>, "publish", to_show,
                  "Make the pages", {"mirocup league publish spring"});
  command
      .option("--pages NIGHT", o.pages,
              "Also make the pages of this night, which mirocup league prune removed")
      .between(1, max_count);
}

void add_prune(system::Commands& commands) {
  const auto [command, o] =
      add_command(commands, on_own_league<run_prune, PruneOptions>, "prune", to_show,
                  "Remove the replay pages of former nights, to make room",
                  {"mirocup league prune spring --before 12"});
  command
      .option("--before NIGHT", o.before,
              "Nights before this one lose their pages; mirocup league publish --pages makes the "
              "pages of a night again")
      .between(2, max_count)
      .required();
}

}  // namespace mirocup::league
