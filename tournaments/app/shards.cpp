// SPDX-License-Identifier: MIT
#include "tournaments/app/commands.hpp"
#include "tournaments/run/begin.hpp"
#include "tournaments/run/shard.hpp"

#include <iostream>

namespace mirocup::league {

Result<int> run_plan(const ShardOptions& options) {
  record::Disk disk;
  auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  if (auto begun = begin_league(disk, *book); !begun) return tl::unexpected(begun.error());
  for (const std::string& id : open_shards(book->state())) std::cout << id << '\n';
  return exit_yes;
}

Result<int> run_shards(const ShardOptions& options) {
  record::Disk disk;
  const auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  int failed = 0;
  for (const std::string& id : options.fixtures) {
    const auto left = run_shard(disk, *book, id);
    if (!left) return tl::unexpected(left.error());
    failed += *left;
  }
  if (failed == 0) return exit_yes;
  return fail(Errc::host, std::to_string(failed) + " legs could not be played; run it again");
}

}  // namespace mirocup::league
