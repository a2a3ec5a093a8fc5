// SPDX-License-Identifier: MIT
//
// The book of the friendlies of a league, friendlies.jsonl, in the form of a journal: a line for
// each leg to play and a line for its end. If a server is killed, the next server continues with
// the legs that have no end. journal/format.md describes the lines.
//
// Threads: one at a time. Processes: the process that holds the lock of the book of hand-ins.
#pragma once

#include "tournaments/handin/friendly.hpp"
#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

namespace mirocup::league {

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
