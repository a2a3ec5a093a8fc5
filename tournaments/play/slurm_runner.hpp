// SPDX-License-Identifier: MIT
//
// Plays the open legs of a league on a Slurm cluster whose nodes see the folder of the league and
// this program at the same paths. Fixtures are dealt to the tasks of an array. Each task runs
// `run-shard`, which writes records. This program books the records. Lost legs are void and are
// submitted again.
//
// Only records prove that legs were played: a fixture is submitted if it has legs without a record
// and is not in the queue under the name of this league. So one command starts and resumes a
// league, and tasks continue if the command ends. DIR/cluster has the plans, the logs and the
// script of the tasks.
#pragma once

#include "system/process_set.hpp"
#include "tournaments/play/result_recorder.hpp"
#include "tournaments/play/slurm.hpp"

#include <map>

namespace mirocup::league {

class SlurmRunner {
 public:
  SlurmRunner(system::Files& files, LeagueStore store, ProgressReporter& progress);

  // Plays as Runner::run() does, with the same meaning of interrupts. `jobs` is the number of tasks
  // that run at once; 0: as many as the cluster has processors. Legs of teams over DDS are not
  // played, since only a single host can play them. Errors: Errc::unavailable if there is no Slurm;
  // Errc::host if arrays of tasks end without a record.
  Result<int> run(int jobs);

  const LeagueState& state() const { return recorder_.state(); }
  int refused() const { return recorder_.refused(); }

 private:
  using PlanLines = std::vector<std::vector<std::string>>;  // the fixtures of each task of a plan

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
  Result<std::vector<std::string>> fixtures_of(const SlurmTask& task);
  std::string plan_path(int number) const;
  int running() const;

  system::Files& files_;
  ResultRecorder recorder_;
  ProgressReporter& progress_;
  system::ProcessSet processes_;
  std::string folder_;  // DIR/cluster, absolute
  std::string league_;  // word in the names of this league's jobs
  int jobs_ = 1;
  int next_plan_ = 1;
  int futile_submissions_ = 0;  // arrays submitted since the last record was booked
  int interrupts_ = 0;
  bool is_silent_ = false;               // true: squeue did not answer last time
  std::vector<SlurmTask> tasks_;         // from the last answer of squeue
  std::map<std::string, int> restarts_;  // by task: the number of its restarts that are booked
  std::map<int, PlanLines> plans_;       // the plans that were read so far
};

}  // namespace mirocup::league
