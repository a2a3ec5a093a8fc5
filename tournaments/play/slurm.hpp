// SPDX-License-Identifier: MIT
//
// Builds the command lines of sbatch, squeue, scancel, scontrol and sinfo, which are Slurm's stable
// interface, and parses the texts that they print. Pure functions; SlurmRunner runs the commands.
#pragma once

#include <string>
#include <vector>

namespace mirocup::league {

using CommandLine = std::vector<std::string>;

// A task of an array that is waiting or running. It plays the fixtures of one line of a plan.
struct SlurmTask {
  std::string id;  // "17_3": job and task, as scancel takes it
  int plan = 0;    // number of the plan
  int line = 0;    // line in the plan, from 1
  bool is_running = false;
  int restarts = 0;  // times that Slurm has requeued it, for example after losing its node
};

// An array of tasks, one for each line of a plan.
struct SlurmArray {
  std::string league;  // a word in the names of this league's jobs, unlike that of other leagues
  int plan = 0;
  int tasks = 0;
  int max_running = 0;
  std::string log;    // path of a task's log, with %a for the number of the task
  CommandLine shard;  // a shell script and its arguments
};

// Returns the command that submits the array.
CommandLine sbatch_command(const SlurmArray& array);

// squeue_command() lists the queue; parse_queue() returns this league's tasks from its output and
// ignores all other lines.
CommandLine squeue_command();
std::vector<SlurmTask> parse_queue(const std::string& text, const std::string& league);

// Cancels tasks: `all` of them; only those that are `pending` when Slurm runs the command; or, by
// an interrupt, the running ones `after_leg`, when the leg in progress is finished.
enum class CancelScope { all, pending, after_leg };
CommandLine scancel_command(const std::vector<std::string>& tasks, CancelScope scope);

// Returns the command that lets a requeued task start at once; Slurm would hold it for two minutes.
CommandLine start_now_command(const std::string& task);

// sinfo_command() asks for the processors; parse_processors() returns their number from its output,
// or 0 if the text has none.
CommandLine sinfo_command();
int parse_processors(const std::string& text);

}  // namespace mirocup::league
