// SPDX-License-Identifier: MIT
//
// Writes the results of legs to the journal, in the same manner for every engine that plays a
// league. A leg is void if the host failed, or if a team lost it by a time limit for the first
// time. A team that loses too many legs in a row by its own faults is paused.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/play/progress_reporter.hpp"

#include <map>
#include <optional>

namespace mirocup::league {

// Number of attempts of a leg that may fail by the host's fault. After these the leg waits for the
// next start of the program, so that the operator can repair the host.
inline constexpr int max_attempts = 3;

class ResultRecorder {
 public:
  ResultRecorder(system::Files& files, LeagueStore store, ProgressReporter& progress);

  const LeagueStore& store() const { return store_; }
  const LeagueState& state() const { return store_.state(); }
  const Folder& folder() const { return store_.folder(); }

  // Starts the league if it is not started.
  Result<void> start();

  // Reads the events that other processes have written since, such as rulings.
  Result<void> refresh() { return store_.refresh(); }

  // Returns the fixture in its present state, or null if it is no longer in the schedule. Valid
  // until the state changes.
  const FixtureState* find(const std::string& id) const;

  // Returns the leg of the fixture that must be played next. Empty if none can be played now, or if
  // the leg has failed max_attempts times by the host's fault since this program started.
  std::optional<LegId> next_leg(const FixtureState& fixture) const;

  // Books the leg if its record exists; otherwise returns false.
  Result<bool> book_if_played(const LegId& leg);

  // Books the legs of a fixture in order until one has no record. Returns the number of booked
  // legs.
  Result<int> book_played(const std::string& fixture);

  // True if a match server has been started for the leg.
  bool has_begun(const LegId& leg) const { return files_.exists(leg_output(folder(), leg)); }

  // Returns the last line that the leg's match server printed.
  std::string last_output_line(const LegId& leg) const;

  // Books the attempt as void by a fault of the host, with the reason `why`.
  Result<void> book_void(const LegId& leg, const std::string& why);

 private:
  Result<void> book_result(const LegId& leg, const LegPlayed& played);
  Result<void> write_void(const LegId& leg, VoidCause cause, const std::string& why);
  Result<void> pause_after_strikes(const Fixture& fixture);
  Result<void> drop_if_outdated(Result<void> result);

  system::Files& files_;
  LeagueStore store_;
  ProgressReporter& progress_;
  std::map<std::string, int> host_failures_;  // by record, since this program started
};

// Returns the error (Errc::interrupted) that tells the operator the state of an interrupted league.
Error interrupted_after(const LeagueState& state);

}  // namespace mirocup::league
