// SPDX-License-Identifier: MIT
//
// Plays what is left of a league on an existing Slurm whose nodes see the league's folder and this
// program at the same place. Fixtures are dealt to the tasks of an array; each task is run-shard,
// which writes records; here records are booked, and what is lost is void and handed in again.
//
// Records are the truth, the queue is a hint: what may be handed in again is what neither has a
// record nor is in the queue under this league's name. So the same command starts and resumes, and
// tasks play on when nobody watches. DIR/cluster has plans, logs and the script of the tasks.
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

  // As Runner::run(): plays until nothing is left or somebody interrupts; the first time legs that
  // are being played come to their end, the second time nothing does. `jobs`: tasks at once; 0: as
  // many as the cluster has processors. What teams over DDS play is left: they belong to one host.
  // Errors: Errc::unavailable if there is no Slurm; Errc::host if it plays nothing.
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
  std::string league_;  // in the names of its jobs
  int jobs_ = 1;
  int next_plan_ = 1;
  int futile_submissions_ = 0;  // arrays handed in since a record was booked
  int interrupts_ = 0;
  bool is_silent_ = false;               // squeue has not answered
  std::vector<SlurmTask> tasks_;         // as squeue said last
  std::map<std::string, int> restarts_;  // of tasks, as far as they were judged
  std::map<int, PlanLines> plans_;       // as far as they were needed
};

}  // namespace mirocup::league
