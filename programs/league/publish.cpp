// SPDX-License-Identifier: MIT
//
// mirocup league publish: makes the pages.
#include "programs/league/commands.hpp"
#include "programs/league/publishing.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/publish/snapshot.hpp"

#include <filesystem>
#include <iostream>

namespace mirocup::league {

namespace {

struct PublishOptions {
  std::string folder;
  std::string output;
  std::string through;  // the last round shown; "": all rounds
  int pages = 0;        // the night whose pages were removed and are made again; 0: none
};

// Has the next pages of the league include those of a night again.
Result<void> restore_night(system::Files& files, const LeagueStore& store, int night) {
  std::set<int> nights = store.state().pruned_nights;
  if (nights.erase(night) == 0)
    return fail(Errc::input, "the pages of night " + std::to_string(night) + " were not removed");
  return write_pruned_nights(files, store.folder(), nights);
}

Result<int> run_publish(const PublishOptions& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  system::Disk disk;
  MIROCUP_TRY(const auto store, LeagueStore::open(disk, Folder{options.folder}));
  if (options.pages > 0) {
    MIROCUP_TRY_VOID(restore_night(disk, store, options.pages));
  }
  // site/ has what is released, so the pages of other rounds go to another folder.
  const Folder folder = options.through.empty() ? store.folder() : Folder{options.output};
  if (!options.through.empty() && disk.exists(folder.config()))
    return fail(Errc::input, "--output " + folder.path +
                                 " is a league, whose records and pages would be replaced: name a "
                                 "folder for the pages alone");
  MIROCUP_TRY(const int published,
              options.through.empty()
                  ? publish_league(disk, folder)
                  : say_gaps(disk, store).and_then([&](const Gaps& found) -> Result<int> {
                      if (!found.lost.empty()) return exit_no;
                      MIROCUP_TRY(const auto shown,
                                  state_through(store.state(), store.journal(), options.through));
                      MIROCUP_TRY_VOID(copy_records(disk, store.folder(), shown, folder));
                      return publish_site(disk, folder, shown, {});
                    }));
  if (published == exit_yes)
    std::cout
        << std::filesystem::absolute(folder.site() + "/index.html").lexically_normal().string()
        << '\n';
  return published;
}

}  // namespace

void add_publish(system::Commands& commands) {
  const auto [command, o] = commands.add(run_publish, "publish", to_show, "Make the pages",
                                         {"mirocup league publish spring"});
  add_folder(command, o.folder);
  const system::Option output =
      command.option("-o,--output", o.output, "Folder for the pages that --through makes")
          .checked("DIR", problem_with_folder);
  const system::Option through =
      command
          .option("--through", o.through,
                  "Leave out all rounds after this one: r3, or k1 of a knockout")
          .needs(output);
  output.needs(through);
  command
      .option("--pages", o.pages,
              "Also make the pages of this night, which mirocup league prune removed")
      .named("NIGHT")
      .between(1, max_count)
      .excludes(through);
}

}  // namespace mirocup::league
