// SPDX-License-Identifier: MIT
//
// The book of the hand-ins of a league, hand-ins.jsonl: a journal like that of the league. Its
// lines are the files that were handed in, their answers, the pins of teams, and friendlies with
// their ends. All that the league knows of these follows from this file. A file, an answer or a pin
// counts from the moment at which its line is on disk; so a process that was killed has done it or
// not.
//
// The book is not part of the league's journal, because teams hand in before the league starts, and
// because only the team may read an answer. journal/format.md describes the lines of the book.
//
// Processes: any number; each writes under a short lock of the file, behind the lines of others.
// Threads: one at a time.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"
#include "tournaments/league/friendly.hpp"
#include "tournaments/league/hand_ins.hpp"

#include <functional>
#include <variant>

namespace mirocup::league {

using BookLine = std::variant<HandedIn, Answered, Rejected, Dropped, TakenLate, Pinned, Friendly,
                              Burst, FriendlyEnded>;

class Book {
 public:
  // Reads the book of a league; a missing file is an empty book. `notice` may get a sentence that
  // the user should read. Errors: Errc::damaged names the line.
  static Result<Book> open(system::Files& files, const Folder& folder,
                           std::string* notice = nullptr);

  const HandIns& hand_ins() const { return hand_ins_; }
  HandIns& hand_ins() { return hand_ins_; }  // for what ends with the server
  const Friendlies& friendlies() const { return friendlies_; }
  Friendlies& friendlies() { return friendlies_; }

  // Reads the lines that other processes have written since the last call.
  Result<void> refresh();

  // Writes a line and applies it.
  Result<void> write(const BookLine& line);

  // Keeps a file as the team's next entry, writes the line about it and returns the number. `store`
  // moves the file to a given path. After an error nothing is left of the file.
  using Store = std::function<Result<void>(const std::string& path)>;
  Result<int> take(HandedIn handed, const Store& store);

  // Keeps a library that the host gives to a team, without a check, as the team's next entry.
  Result<void> give(const std::string& team, const std::string& library);

 private:
  Book(system::Files& files, Folder folder, Journal journal)
      : files_(&files), folder_(std::move(folder)), journal_(std::move(journal)) {}

  // Requires the lock of the file, and all lines of other processes.
  Result<void> append(const BookLine& line);
  // Returns why a line cannot follow the lines before it; "" if it can.
  std::string objection_to(const BookLine& line) const;
  void apply(const BookLine& line);

  system::Files* files_;
  Folder folder_;
  Journal journal_;
  std::size_t applied_ = 0;  // number of applied lines
  HandIns hand_ins_;
  Friendlies friendlies_;
};

}  // namespace mirocup::league
