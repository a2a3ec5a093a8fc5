// SPDX-License-Identifier: MIT
#include "tournaments/play/slurm.hpp"

#include "system/number_of.hpp"

#include <algorithm>
#include <sstream>

namespace mirocup::league {

namespace {

constexpr const char* job_prefix = "mirocup-";

std::string job_name(const std::string& league) {
  return job_prefix + league + "-";
}

// Escapes a file name, in which Slurm replaces %a and similar patterns.
std::string taken_as_written(const std::string& path) {
  std::string text;
  for (const char c : path) text.append(c == '%' ? 2 : 1, c);
  return text;
}

}  // namespace

CommandLine sbatch_command(const SlurmArray& array) {
  CommandLine command{"sbatch", "--parsable", "--requeue", "--ntasks=1", "--cpus-per-task=1"};
  command.insert(command.end(), {"--chdir=/", "--open-mode=append"});
  command.push_back("--job-name=" + job_name(array.league) + std::to_string(array.plan));
  command.push_back("--array=1-" + std::to_string(array.tasks) + "%" +
                    std::to_string(array.max_running));
  command.push_back("--output=" + taken_as_written(array.log) + "-%a.log");
  command.insert(command.end(), array.shard.begin(), array.shard.end());
  return command;
}

CommandLine squeue_command() {
  return {"squeue",
          "--me",
          "--noheader",
          "--array",
          "--states=PENDING,CONFIGURING,RUNNING,SUSPENDED,STOPPED",
          "--Format=Name:64,ArrayJobID:24,ArrayTaskID:24,State:24,RestartCnt:24"};
}

std::vector<SlurmTask> parse_queue(const std::string& text, const std::string& league) {
  const std::string prefix = job_name(league);
  std::vector<SlurmTask> tasks;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, job, index, state, restarts;
    if (!(words >> name >> job >> index >> state >> restarts) || !name.starts_with(prefix))
      continue;
    const auto plan = system::number_of<int>(std::string_view(name).substr(prefix.size()));
    const auto task = system::number_of<int>(index);
    if (!plan || !task) continue;
    tasks.push_back({.id = job + "_" + index,
                     .plan = *plan,
                     .line = *task,
                     .is_running = state == "RUNNING",
                     .restarts = system::number_of<int>(restarts).value_or(0)});
  }
  return tasks;
}

CommandLine scancel_command(const std::vector<std::string>& tasks, CancelScope scope) {
  CommandLine command{"scancel"};
  if (scope == CancelScope::pending) command.push_back("--state=PENDING");
  // The interrupt must reach the shard alone, not the match server that it runs.
  if (scope == CancelScope::after_leg) command.insert(command.end(), {"--batch", "--signal=INT"});
  command.insert(command.end(), tasks.begin(), tasks.end());
  return command;
}

CommandLine start_now_command(const std::string& task) {
  return {"scontrol", "update", "JobId=" + task, "StartTime=now"};
}

CommandLine sinfo_command() {
  return {"sinfo", "--noheader", "--format=%C"};
}

int parse_processors(const std::string& text) {
  // Each line is allocated/idle/other/total of one kind of node; "other" processors cannot play
  // now.
  int processors = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    int allocated = 0, idle = 0;
    char slash = 0;
    if (numbers >> allocated >> slash >> idle) processors = std::max(processors, allocated + idle);
  }
  return processors;
}

}  // namespace mirocup::league
