// SPDX-License-Identifier: MIT
//
// Turns match records into events of the journal, alike for every engine that plays a league. A leg
// gets its result. But the attempt is void if the host failed, if the record came from elsewhere
// and differs from its replay, or if a team lost the leg by exceeding a time limit for the first
// time. A team that loses LeagueFile::strikes legs in a row by its own faults is paused.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/play/progress_reporter.hpp"

#include <map>
#include <optional>

namespace mirocup::league {

class ResultRecorder {
 public:
  ResultRecorder(system::Files& files, LeagueStore store, ProgressReporter& progress);

  const LeagueStore& store() const { return store_; }
  const LeagueState& state() const { return store_.state(); }
  const Folder& folder() const { return store_.folder(); }

  // Starts the league unless it has started. `jobs` records are verified at once (0: one for each
  // processor).
  Result<void> start(int jobs = 0);

  // Reads the events that other processes have written, such as a person's rulings.
  Result<void> refresh() { return store_.refresh(); }

  // Returns the fixture with an id; null if the schedule no longer has the fixture. The pointer is
  // valid until the next change of the state.
  const FixtureState* find(const std::string& id) const;

  // Returns the next leg of a fixture. Returns nothing if no leg can be played now, or if the host
  // has failed max_attempts times while this program ran.
  std::optional<LegId> next_leg(const FixtureState& fixture) const;

  // Books a leg that a child of this process has played. Returns false if no record exists.
  Result<bool> book_own(const LegId& leg);

  // Books a leg whose record another process may have written: verifies it together with the other
  // such records. A leg that differs from its record is void, and its next attempt has another
  // seed. Returns false if no record exists. Errors include Errc::damaged for a record that cannot
  // be verified, because it is damaged or another version of the game has played it.
  Result<bool> book_found(const LegId& leg);

  // Calls book_found() for the legs of a fixture in order until a leg has no record. Returns the
  // number of records.
  Result<int> book_played(const std::string& fixture);

  // The number of records that differ from their replays.
  int refused() const { return refused_; }

  // True if a match server has been started for the leg.
  bool has_begun(const LegId& leg) const { return files_.exists(leg_output(folder(), leg)); }

  // Returns the last line that the leg's match server printed.
  std::string last_output_line(const LegId& leg) const;

  // Voids an attempt after a failure of the host.
  Result<void> book_void(const LegId& leg, const std::string& why);

 private:
  Result<void> book_result(const LegId& leg, const LegPlayed& played);
  Result<void> check_found();
  Result<void> write_void(const LegId& leg, VoidCause cause, const std::string& why,
                          bool has_new_seed = false);
  Result<void> pause_after_strikes(const Fixture& fixture);
  Result<void> drop_if_outdated(Result<void> result);

  system::Files& files_;
  LeagueStore store_;
  ProgressReporter& progress_;
  std::map<std::string, int> host_failures_;  // by the leg, while this program runs
  // By the path of a record that waits to be booked: how it differs from its replay; "": not.
  std::map<std::string, std::string> checked_;
  int jobs_ = 0;
  int refused_ = 0;
};

// Returns the error for a person who has interrupted the league.
Error interrupted_after(const LeagueState& state);

}  // namespace mirocup::league
