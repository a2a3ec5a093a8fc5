// SPDX-License-Identifier: MIT
//
// Plays the open legs of a league on an existing Slurm cluster, whose nodes must see the league's
// folder and this program under the same paths. Fixtures are dealt to the tasks of a job array. A
// task runs `run-shard`, which writes records. This class books the records; a lost leg is void and
// submitted again.
//
// A fixture is submitted if it has a leg without a record and is not in the queue under this
// league's name. So the same command starts and resumes a league, and tasks play on while this
// program is not running. DIR/cluster has the plans, the logs and the script of the tasks.
#pragma once

#include "server/system/process_set.hpp"
#include "tournaments/play/result_recorder.hpp"
#include "tournaments/play/slurm.hpp"

#include <map>
#include <set>

namespace mirocup::league {

class SlurmRunner {
 public:
  SlurmRunner(system::Files& files, LeagueStore store, ProgressReporter& progress);

  // Plays until no leg can be played or an interrupt arrives, as Runner::run(): after the first
  // interrupt the legs in progress are finished, a second one does not wait for them. `jobs` is the
  // number of tasks at once; 0: the number of the cluster's processors. Fixtures of teams over DDS
  // are left out, because they need the network of one host. Returns the number of legs that are
  // not decided. Errors: Errc::unavailable if there is no Slurm; Errc::host if Slurm plays nothing.
  Result<int> run(int jobs);

  const LeagueState& state() const { return recorder_.state(); }

 private:
  using PlanLines = std::vector<std::vector<std::string>>;  // fixtures of each task of a plan

  Result<void> prepare(int jobs);
  Result<std::string> run_slurm(const CommandLine& command);
  bool poll_queue();
  Result<void> book_after(const std::vector<SlurmTask>& before, bool is_known);
  Result<void> book_records(const std::string& fixture);
  Result<void> book_lost(const std::string& fixture, const std::string& why);
  Result<void> requeue(const SlurmTask& task);
  Result<std::vector<std::string>> unqueued_fixtures();
  Result<void> submit(const std::vector<std::string>& fixtures);
  Result<void> submit_array(const std::vector<std::string>& fixtures);
  void drain();
  std::vector<std::string> fixtures_of(const SlurmTask& task);
  std::string plan_path(int number) const;
  int running() const;

  system::Files& files_;
  ResultRecorder recorder_;
  ProgressReporter& progress_;
  system::ProcessSet processes_;
  std::string folder_;  // DIR/cluster, absolute
  std::string league_;  // word in the names of its jobs
  int jobs_ = 1;
  int next_plan_ = 1;
  int futile_submissions_ = 0;  // arrays submitted since the last record was booked
  int interrupts_ = 0;
  bool is_silent_ = false;               // squeue has not answered
  std::vector<SlurmTask> tasks_;         // from the last answer of squeue
  std::map<std::string, int> restarts_;  // by task: restarts that have been handled
  std::map<int, PlanLines> plans_;       // cache of the plans that were read
};

}  // namespace mirocup::league
