// SPDX-License-Identifier: MIT
#include "tournaments/app/commands.hpp"
#include "tournaments/app/progress_bar.hpp"
#include "tournaments/play/result_recorder.hpp"
#include "tournaments/play/shard.hpp"

#include <iostream>

namespace mirocup::league {

// What shards have played is booked first: it may open the next round.
Result<int> run_plan(const ShardOptions& options) {
  system::Disk disk;
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

Result<int> run_shards(const ShardOptions& options) {
  system::Disk disk;
  const auto book = Book::open(disk, Folder{options.folder});
  if (!book) return tl::unexpected(book.error());
  const auto failed = play_shards(disk, *book, options.fixtures);
  if (!failed) return tl::unexpected(failed.error());
  if (*failed == 0) return exit_yes;
  return fail(Errc::host, std::to_string(*failed) + " legs could not be played; run it again");
}

}  // namespace mirocup::league
