// SPDX-License-Identifier: MIT
#include "tournaments/app/commands.hpp"
#include "tournaments/app/progress_bar.hpp"
#include "tournaments/run/bookkeeper.hpp"
#include "tournaments/run/shard.hpp"

#include <iostream>
#include <memory>

namespace mirocup::league {

namespace {

struct Options {
  std::string folder;
  std::vector<std::string> fixtures;
};

// What shards have played is booked first: it may open the next round.
Result<int> plan(const Options& options) {
  record::Disk disk;
  auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  const auto progress = make_progress();
  Bookkeeper books(disk, std::move(*book), *progress);
  if (auto begun = books.begin(); !begun) return tl::unexpected(begun.error());
  for (int booked = 1; booked > 0;) {
    booked = 0;
    for (const std::string& id : open_shards(books.state())) {
      const auto count = books.book_played(id);
      if (!count) return tl::unexpected(count.error());
      booked += *count;
    }
  }
  for (const std::string& id : open_shards(books.state())) std::cout << id << '\n';
  return exit_yes;
}

Result<int> run_shard(const Options& options) {
  record::Disk disk;
  const auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  const auto failed = run_shards(disk, *book, options.fixtures);
  if (!failed) return tl::unexpected(failed.error());
  if (*failed == 0) return exit_yes;
  return fail(Errc::host, std::to_string(*failed) + " legs could not be played; run it again");
}

}  // namespace

void add_shards(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* plan_command = app.add_subcommand(
      "plan", "Start the league, book what shards have played, and list what can be played now");
  plan_command->add_option("DIR", options->folder, "the league's folder")->required();
  plan_command->callback([options, &run] { run = [options] { return plan(*options); }; });

  CLI::App* shard = app.add_subcommand(
      "run-shard", "Play fixtures into records only, on any machine; league start books them");
  shard->add_option("DIR", options->folder, "the league's folder")->required();
  shard->add_option("FIXTURE", options->fixtures, "ids, as league plan lists them")->required();
  shard->callback([options, &run] { run = [options] { return run_shard(*options); }; });
}

}  // namespace mirocup::league
