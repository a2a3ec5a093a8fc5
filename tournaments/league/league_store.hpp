// SPDX-License-Identifier: MIT
//
// An open league: its journal and the state that follows from it, always in agreement. An event is
// written under a lock, after the events of other processes have been read, because a person may
// rule on a leg while the league is being played.
//
// Threads: one at a time.
#pragma once

#include "system/clock.hpp"
#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

#include <cstddef>
#include <string>

namespace mirocup::league {

class LeagueStore {
 public:
  // Opens the league in the folder. `notice` may get a sentence that the user should read. `files`
  // must outlive the store. Errors: Errc::input if the folder holds no league, or if league.json is
  // wrong or has changed since the start; Errc::damaged if the journal is damaged.
  static Result<LeagueStore> open(system::Files& files, Folder folder,
                                  std::string* notice = nullptr);

  // Opens a league like open(), for a caller that needs only the teams. A league that has not
  // started gets no fixtures, which saves most of the time.
  static Result<LeagueStore> open_unplanned(system::Files& files, Folder folder,
                                            std::string* notice = nullptr);

  const LeagueState& state() const { return state_; }
  const Journal& journal() const { return journal_; }
  const Folder& folder() const { return folder_; }

  // Returns the number of lines of the journal that are applied to the state.
  std::size_t lines() const { return applied_; }

  // Reads and applies the events that other processes have written.
  Result<void> refresh();

  // Writes an event to disk and then applies it to the state. If the present state does not allow
  // the event, the error is Errc::input and nothing is written.
  Result<void> write(const Event& event);

 private:
  LeagueStore(Folder folder, Journal journal, LeagueState state);
  Result<void> write_line(const Event& event);
  Result<void> rebuild();

  Folder folder_;
  Journal journal_;
  LeagueState state_;
  std::size_t applied_;  // number of applied lines
};

// Starts the league if it has not started (league.json is frozen, and the entries that play are
// booked), and checks that the libraries have the digests in the journal. Errors: Errc::input if
// the league cannot be played; Errc::damaged if a library has changed, or if the journal has lost
// lines.
Result<void> start_league(system::Files& files, LeagueStore& store);

}  // namespace mirocup::league
