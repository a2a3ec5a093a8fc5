// SPDX-License-Identifier: MIT
//
// Plays the open legs of a league on this host. Each leg is a child process that runs the match
// server, with as many at once as there are jobs. The legs of a fixture follow each other on one
// processor.
//
// A finished leg is written to the journal before the next one starts on its processor. A leg that
// fails by the host's fault is void and played again with the same seed; so is, once, a leg that a
// team lost by a time limit. No behaviour of a team can stop a league; a team that loses too many
// legs in a row by its own faults is paused.
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

  // Starts the league if it has not started, and plays until no leg can be played or an interrupt
  // arrives. After the first interrupt the legs in progress are finished; a second one kills them.
  // The error after an interrupt is Errc::interrupted. Returns the number of legs that are not
  // decided.
  Result<int> run(const RunOptions& options);

  const LeagueState& state() const { return recorder_.state(); }

 private:
  // A processor, which plays at most one fixture at a time.
  struct Worker {
    int cpu = -1;
    std::string fixture;           // its id; "": the worker is free
    std::optional<LegId> playing;  // has the fixture in its state at the start of the leg
    pid_t joiner[2] = {0, 0};      // `mirocup join` processes of DDS teams, blue and yellow
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
  std::set<std::string> checked_records_;  // records that were searched for before playing
};

}  // namespace mirocup::league
