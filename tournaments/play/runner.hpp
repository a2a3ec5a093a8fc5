// SPDX-License-Identifier: MIT
//
// Plays the open legs of a league on this host. Each leg is a child process, a match server. As
// many legs run at once as there are jobs; the legs of a fixture run one after the other on the
// same processor.
//
// A finished leg is booked in the journal at once. If the host spoiled a leg, the leg is void and
// is played again with the same seed. So is a leg that a team lost by exceeding a time limit for
// the first time. A team cannot stop a league.
#pragma once

#include "system/process_set.hpp"
#include "tournaments/play/progress_reporter.hpp"
#include "tournaments/play/result_recorder.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace mirocup::league {

struct RunOptions {
  int jobs = 0;          // 0: one for each processor
  bool watched = false;  // true: each leg opens a live page on this host
  int dds_domain = 0;    // the DDS domain of legs with teams over DDS
  bool nat = false;      // true: a match answers teams over DDS where their packets come from
};

// Returns a sentence for the host if `jobs` legs at once may take more memory than `available`,
// bytes; "" if the memory is enough, or if `available` is empty.
std::string memory_warning(std::optional<std::size_t> available, int jobs);

class Runner {
 public:
  Runner(system::Files& files, LeagueStore store, ProgressReporter& progress);

  // Starts the league if it has not started, and plays until no leg can be played. Returns the
  // number of legs that are not decided. After the first interrupt (SIGINT or SIGTERM) the present
  // legs are still played to their end. The second interrupt stops them. After either interrupt the
  // error is Errc::interrupted.
  Result<int> run(const RunOptions& options);

  const LeagueState& state() const { return recorder_.state(); }
  int refused() const { return recorder_.refused(); }

 private:
  // A processor that plays the legs of one fixture at a time.
  struct Worker {
    int cpu = -1;
    std::string fixture;           // the id of its fixture; "": the processor is free
    std::optional<LegId> playing;  // LegId::fixture is a copy, made when the leg started
    pid_t joiner[2] = {0, 0};      // processes of mirocup join for DDS teams, blue and yellow
  };

  Result<void> fill_workers();
  Result<void> start_next_leg(Worker& worker);
  bool is_taken(const std::string& id) const;
  const FixtureState* next_fixture(const Worker& worker) const;
  bool may_play(const Worker& worker, const FixtureState& fixture) const;
  void tell_people(const LegId& leg, int blue, int yellow) const;
  Result<void> start_leg(Worker& worker);
  // Adds the options of a leg on the network; `whose` is a folder of credentials.
  void add_network(std::vector<std::string>& command, const std::string& whose) const;
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
  std::set<std::string> checked_records_;  // names of records that run() has searched for
};

}  // namespace mirocup::league
