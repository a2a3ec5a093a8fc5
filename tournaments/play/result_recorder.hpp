// SPDX-License-Identifier: MIT
//
// What became of a leg, as lines of the journal: its result; void if the host spoiled it, or if
// only a clock decided it for the first time; a pause for a team that loses leg after leg by its
// own faults. The same for every engine that plays a league.
#pragma once

#include "tournaments/league/league_store.hpp"
#include "tournaments/play/leg_command.hpp"
#include "tournaments/play/progress_reporter.hpp"

#include <map>
#include <optional>

namespace mirocup::league {

// After so many attempts that the host spoiled a leg is left until the next start, when somebody
// may have looked after the host.
inline constexpr int max_attempts = 3;

class ResultRecorder {
 public:
  ResultRecorder(system::Files& files, LeagueStore store, ProgressReporter& progress);

  const LeagueStore& store() const { return store_; }
  const LeagueState& state() const { return store_.state(); }
  const Folder& folder() const { return store_.folder(); }

  // Starts the league if it is not started.
  Result<void> start();

  // Takes in what persons have decided since.
  Result<void> refresh() { return store_.refresh(); }

  // The fixture as it is now, if there still is one.
  const FixtureState* find(const std::string& id) const;

  // The leg of a fixture that is to be played next; nothing if none can be played now, or if the
  // host has spoiled it too often while this program ran.
  std::optional<LegId> next_leg(const FixtureState& fixture) const;

  // Books the leg if its record is there; false if it is not.
  Result<bool> book_if_played(const LegId& leg);

  // Books the legs of a fixture one after the other as long as there are records; how many.
  Result<int> book_played(const std::string& fixture);

  // Has a match server been started for it? What did it say last?
  bool has_begun(const LegId& leg) const { return files_.exists(leg_output(folder(), leg)); }
  std::string last_output_line(const LegId& leg) const;

  // The host spoiled it.
  Result<void> book_void(const LegId& leg, const std::string& why);

 private:
  Result<void> book_result(const LegId& leg, const LegPlayed& played);
  Result<void> write_void(const LegId& leg, VoidCause cause, const std::string& why);
  Result<void> pause_after_strikes(const Fixture& fixture);
  Result<void> drop_if_outdated(Result<void> result);

  system::Files& files_;
  LeagueStore store_;
  ProgressReporter& progress_;
  std::map<std::string, int> host_failures_;  // by the host, while this program runs: records
};

// What to tell whoever interrupted the league.
Error interrupted_after(const LeagueState& state);

}  // namespace mirocup::league
