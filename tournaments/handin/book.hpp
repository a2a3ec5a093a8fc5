// SPDX-License-Identifier: MIT
//
// The book of the hand-ins of a league, hand-ins.jsonl: a journal like that of the league, with a
// line for each file that came in over the network and a line for each answer. The server confirms
// a file, or gives the answer to a file, only after the line is on disk. So a server that was
// killed continues from the book.
//
// The book is not part of the league's journal, because teams hand in before the league starts, and
// because only the team may read an answer. journal/format.md describes the lines of the book.
//
// Threads: one at a time. Processes: the one that holds the lock.
#pragma once

#include "system/file_lock.hpp"
#include "tournaments/handin/friendly.hpp"
#include "tournaments/handin/queue.hpp"
#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

#include <functional>
#include <optional>

namespace mirocup::league {

class HandInBook {
 public:
  // Opens the book of a league, or makes a new one. `notice` may get a sentence that the user
  // should read. Errors: Errc::unavailable if another process has the book open, Errc::damaged.
  static Result<HandInBook> open(system::Files& files, const Folder& folder, std::string* notice);

  const HandInQueue& queue() const { return queue_; }

  // Keeps an arrived file as the team's next entry and writes a line about it. `store` moves the
  // file to a given path. After an error the book has no line about the file.
  Result<int> take(WaitingHandIn handed,
                   const std::function<Result<void>(const std::string& path)>& store);

  // Writes the answer to a hand-in and applies the answer to the queue.
  Result<void> answer(const std::string& team, int entry, HandInState state,
                      const std::string& message, std::int64_t at, int plays = 0);

  // Writes the entry that a team has pinned (0: its latest) into the book, before pin_entry() does
  // the rest. If this server dies in between, the next server does the rest.
  Result<void> pin(const std::string& team, int entry, std::int64_t at);
  const std::map<std::string, int>& pins() const { return pins_; }
  int pins_in_last_hour(const std::string& team, std::int64_t now) const;

  // The book does not keep these changes of state, because they end with the server.
  void begin(const std::string& team, int entry, HandInState state = HandInState::checking) {
    queue_.begin(team, entry, state);
  }
  void wait_again(const std::string& team, int entry, NoAnswer why = NoAnswer::host_failed) {
    queue_.wait_again(team, entry, why);
  }

 private:
  HandInBook(system::Files& files, Folder folder, Journal journal)
      : files_(&files), folder_(std::move(folder)), journal_(std::move(journal)) {}

  Result<void> apply(const Json& line);

  system::Files* files_;
  Folder folder_;
  Journal journal_;
  HandInQueue queue_;
  std::map<std::string, int> pins_;                             // the last pin of each team
  std::map<std::string, std::vector<std::int64_t>> pin_times_;  // s since 1970
  std::optional<system::FileLock> lock_;
};

// The book of the friendlies of a league, friendlies.jsonl: a line for each leg to play and a line
// for its end. The next server continues with the legs that have no end. The process that holds the
// lock of the book of hand-ins may use it.
class FriendlyBook {
 public:
  static Result<FriendlyBook> open(system::Files& files, const Folder& folder, std::string* notice);

  const Friendlies& friendlies() const { return friendlies_; }

  // Writes a leg to play, with the team's next number, and returns the number.
  Result<int> add(Friendly friendly);

  // Writes how a leg ended.
  Result<void> finish(const std::string& team, int number, FriendlyState state, int goals,
                      int against, const std::string& end, std::int64_t at);

  void begin(const std::string& team, int number) { friendlies_.begin(team, number); }
  void wait_again(const std::string& team, int number, bool is_spoiled) {
    friendlies_.wait_again(team, number, is_spoiled);
  }

 private:
  explicit FriendlyBook(Journal journal) : journal_(std::move(journal)) {}

  Result<void> apply(const Json& line);

  Journal journal_;
  Friendlies friendlies_;
};

}  // namespace mirocup::league
