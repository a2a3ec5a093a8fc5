// SPDX-License-Identifier: MIT
//
// What is said to Slurm and what it answers: the command lines of sbatch, squeue, scancel, scontrol
// and sinfo, which have been its stable interface, and the texts that they print. Pure; who runs
// them is SlurmRunner.
#pragma once

#include <string>
#include <vector>

namespace mirocup::league {

using CommandLine = std::vector<std::string>;

// A task of an array that is waiting or running. It plays the fixtures of one line of a plan.
struct SlurmTask {
  std::string id;  // "17_3": job and task, as scancel takes it
  int plan = 0;    // number of the plan
  int line = 0;    // in it, from 1
  bool is_running = false;
  int restarts = 0;  // so often Slurm has put it back into the queue: its node was lost, say
};

// An array of tasks, one for each line of a plan.
struct SlurmArray {
  std::string league;  // what tells this league's jobs from others: a word
  int plan = 0;
  int tasks = 0;
  int max_running = 0;
  std::string log;    // of task %a
  CommandLine shard;  // a shell script and its arguments
};

CommandLine sbatch_command(const SlurmArray& array);

// This league's tasks that are in the queue; others are left out, and so is what is no task.
CommandLine squeue_command();
std::vector<SlurmTask> parse_queue(const std::string& text, const std::string& league);

// Takes tasks back: all; only those that wait, whatever was known of them; or, with an interrupt,
// those that run when their present leg is played.
enum class CancelScope { all, pending, after_leg };
CommandLine scancel_command(const std::vector<std::string>& tasks, CancelScope scope);

// Slurm holds a task that it has put back for two minutes; this lets it go.
CommandLine start_now_command(const std::string& task);

// The processors of the cluster; 0 if the text does not say.
CommandLine sinfo_command();
int parse_processors(const std::string& text);

}  // namespace mirocup::league
