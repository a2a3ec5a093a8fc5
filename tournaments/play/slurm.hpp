// SPDX-License-Identifier: MIT
//
// The interface to Slurm: the command lines of sbatch, squeue, scancel, scontrol and sinfo, and the
// output of these commands. These functions are pure; SlurmRunner runs the commands.
#pragma once

#include <string>
#include <vector>

namespace mirocup::league {

using CommandLine = std::vector<std::string>;

// A task of an array, pending or running. A task plays the fixtures of one line of a plan.
struct SlurmTask {
  std::string id;  // "17_3": job and task, as scancel expects
  int plan = 0;    // number of the plan
  int line = 0;    // line of the plan, from 1
  bool is_running = false;
  int restarts = 0;  // how often Slurm has requeued the task, for example after a lost node
};

// An array of tasks, one for each line of a plan.
struct SlurmArray {
  std::string league;  // a word that only the names of this league's jobs have
  int plan = 0;
  int tasks = 0;
  int max_running = 0;
  std::string log;    // path of the logs; task A writes to LOG-A.log
  CommandLine shard;  // a shell script and its arguments
};

// Returns the command that submits the array.
CommandLine sbatch_command(const SlurmArray& array);

// The command lists the queue. parse_queue() returns the tasks of this league and ignores all other
// lines.
CommandLine squeue_command();
std::vector<SlurmTask> parse_queue(const std::string& text, const std::string& league);

// Three commands: cancel all tasks, cancel pending tasks, and interrupt running tasks, which end
// after their present leg.
enum class CancelScope { all, pending, after_leg };
CommandLine scancel_command(const std::vector<std::string>& tasks, CancelScope scope);

// Slurm delays a requeued task by two minutes. With this command the task may start at once.
CommandLine start_now_command(const std::string& task);

// The command asks for the processors of the cluster. parse_processors() returns their number; 0 if
// the text does not name the number.
CommandLine sinfo_command();
int parse_processors(const std::string& text);

}  // namespace mirocup::league
