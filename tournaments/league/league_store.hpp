// SPDX-License-Identifier: MIT
//
// An open league: its journal and the state that follows from it, kept consistent. An event is
// written under a lock, after the events of other processes have been read: a person may rule on a
// leg while the league is being played.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

namespace mirocup::league {

class LeagueStore {
 public:
  // Opens the league in the folder. `notice` is set to a sentence for a person if a torn last line
  // of the journal was ignored. The store keeps a reference to `files`.
  static Result<LeagueStore> open(system::Files& files, Folder folder,
                                  std::string* notice = nullptr);

  const LeagueState& state() const { return state_; }
  const Journal& journal() const { return journal_; }
  const Folder& folder() const { return folder_; }

  // Returns the number of journal lines that the state contains.
  std::size_t lines() const { return applied_; }

  // Reads and applies the lines that other processes have written.
  Result<void> refresh();

  // Writes an event to disk and then applies it to the state. Error: Errc::input if the present
  // state does not allow the event; then nothing is written.
  Result<void> write(const Event& event);

 private:
  LeagueStore(Folder folder, Journal journal, LeagueState state)
      : folder_(std::move(folder)), journal_(std::move(journal)), state_(std::move(state)) {}

  Folder folder_;
  Journal journal_;
  LeagueState state_;
  std::size_t applied_ = 0;  // lines
};

}  // namespace mirocup::league
