// SPDX-License-Identifier: MIT
//
// Plays what is left of a league: legs as child processes of the match server program, as many at
// once as there are jobs, both legs of a fixture one after the other on the same processor.
//
// A finished leg is in the journal before anything else happens; a leg that the host lost is void
// and played again with the same seed. Nothing that a team does can stop a league.
#pragma once

#include "tournaments/run/folder.hpp"
#include "tournaments/run/process_set.hpp"

#include <functional>

namespace mirocup::league {

struct RunOptions {
  int jobs = 0;  // 0: one for each processor
};

// After so many void attempts a leg is left for a person to look at.
inline constexpr int most_attempts = 3;

// What to tell a person while the league runs.
using Progress = std::function<void(const std::string&)>;

class Runner {
 public:
  Runner(record::Files& files, Folder folder, OpenLeague league, Progress progress);

  // Starts the league if it is not, plays until nothing is left or somebody interrupts
  // (Errc::interrupted). The value is the number of legs that could not be decided.
  Result<int> run(const RunOptions& options);

  const LeagueState& state() const { return league_.state; }

 private:
  // A place to play on: one processor, at most one fixture.
  struct Slot {
    int cpu = -1;
    int fixture = -1;          // index, -1: free
    int leg = 0;               // being played
    pid_t joiner[2] = {0, 0};  // mirocup join for DDS teams, blue and yellow
  };

  Result<void> start_league();
  Result<void> check_entries();
  std::optional<int> next_leg(const FixtureState& fixture) const;
  bool is_taken(int fixture) const;
  Result<bool> fill(Slot& slot);
  Result<void> start_leg(Slot& slot);
  std::vector<std::string> credentials_of(const std::string& whose) const;
  Result<void> start_joiner(Slot& slot, int team, const std::string& colour,
                            const std::string& match_id);
  Result<void> finish(Slot& slot, const Exit& exit);
  Result<void> book(const Slot& slot, int attempt);
  Result<void> book_void(const Slot& slot, int attempt, const std::string& why);
  std::string seat_of(int team) const;
  int attempt_of(const Slot& slot) const;

  record::Files& files_;
  Folder folder_;
  OpenLeague league_;
  Progress progress_;
  ProcessSet processes_;
  std::vector<Slot> slots_;
};

}  // namespace mirocup::league
