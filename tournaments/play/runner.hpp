// SPDX-License-Identifier: MIT
//
// Plays what is left of a league: legs as child processes of the match server program, as many at
// once as there are jobs, the legs of a fixture one after the other on the same processor.
//
// A finished leg is in the journal before anything else happens; a leg that the host lost is void
// and played again with the same seed, and so is, once, a leg that a clock decided. Nothing that a
// team does can stop a league; a team that loses leg after leg by its own faults is paused.
#pragma once

#include "server/system/process_set.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/play/result_recorder.hpp"

#include <optional>
#include <set>

namespace mirocup::league {

struct RunOptions {
  int jobs = 0;          // 0: one for each processor
  bool watched = false;  // each leg opens a live page on this host
};

class Runner {
 public:
  Runner(system::Files& files, LeagueStore store, ProgressReporter& progress);

  // Starts the league if it is not, plays until nothing is left or somebody interrupts: the first
  // time legs that are being played come to their end, the second time nothing does
  // (Errc::interrupted). The value is the number of legs that are not decided.
  Result<int> run(const RunOptions& options);

  const LeagueState& state() const { return recorder_.state(); }

 private:
  // A place to play on: one processor, at most one fixture.
  struct Worker {
    int cpu = -1;
    std::string fixture;           // its id; "": free
    std::optional<LegId> playing;  // its fixture as it was when the leg began
    pid_t joiner[2] = {0, 0};      // mirocup join for DDS teams, blue and yellow
  };

  Result<bool> fill_workers();
  Result<bool> start_next_leg(Worker& worker);
  bool is_taken(const std::string& id) const;
  const FixtureState* next_fixture(const Worker& worker) const;
  Result<void> start_leg(Worker& worker);
  std::vector<std::string> credentials_of(const std::string& whose) const;
  Result<void> start_joiner(Worker& worker, int team, const std::string& colour,
                            const std::string& match_id);
  Result<void> finish(Worker& worker, const system::Exit& exit);
  int playing() const;

  system::Files& files_;
  RunOptions options_;
  ResultRecorder recorder_;
  ProgressReporter& progress_;
  system::ProcessSet processes_;
  std::vector<Worker> workers_;
  std::set<std::string> checked_records_;  // records: was it there already?
};

}  // namespace mirocup::league
