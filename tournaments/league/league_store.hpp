// SPDX-License-Identifier: MIT
//
// A league that is open: its journal and where it stands, always of one mind. A decision is taken
// under a lock, after reading what others have decided since: a person may rule on a leg while the
// league is being played.
#pragma once

#include "tournaments/journal/journal.hpp"
#include "tournaments/league/folder.hpp"

namespace mirocup::league {

class LeagueStore {
 public:
  // `notice` may be set to something that a person should know.
  static Result<LeagueStore> open(system::Files& files, Folder folder,
                                  std::string* notice = nullptr);

  const LeagueState& state() const { return state_; }
  const Journal& journal() const { return journal_; }
  const Folder& folder() const { return folder_; }

  // So many lines of the journal are in the state.
  std::size_t lines() const { return applied_; }

  // Takes in what others have written.
  Result<void> refresh();

  // Writes an event to disk and then applies it to the state. Errors: Errc::input if it does not
  // fit the league as it is now; then nothing is written.
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
