// SPDX-License-Identifier: MIT
#include "tournaments/app/commands.hpp"
#include "tournaments/run/begin.hpp"
#include "tournaments/run/shard.hpp"

#include <iostream>
#include <memory>

namespace mirocup::league {

namespace {

struct Options {
  std::string folder;
  std::vector<std::string> fixtures;
};

Result<int> plan(const Options& options) {
  record::Disk disk;
  auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  if (auto begun = begin_league(disk, *book); !begun) return tl::unexpected(begun.error());
  for (const std::string& id : open_shards(book->state())) std::cout << id << '\n';
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
  CLI::App* plan_command =
      app.add_subcommand("plan", "Start the league, and list the fixtures that can be played now");
  plan_command->add_option("DIR", options->folder, "the league's folder")->required();
  plan_command->callback([options, &run] { run = [options] { return plan(*options); }; });

  CLI::App* shard = app.add_subcommand(
      "run-shard", "Play fixtures into records only, on any machine; league start books them");
  shard->add_option("DIR", options->folder, "the league's folder")->required();
  shard->add_option("FIXTURE", options->fixtures, "ids, as league plan lists them")->required();
  shard->callback([options, &run] { run = [options] { return run_shard(*options); }; });
}

}  // namespace mirocup::league
