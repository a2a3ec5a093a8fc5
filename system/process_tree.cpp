// SPDX-License-Identifier: MIT
#include "system/process_tree.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <unistd.h>

namespace mirocup::system {

namespace {

struct Process {
  pid_t parent = 0;
  double seconds = 0.0;  // of itself and of the children that it has waited for
  bool is_runnable = false;
};

// Reads /proc/PID/stat. Nothing if the process has gone.
std::optional<Process> read_process(const std::filesystem::path& folder) {
  std::ifstream file(folder / "stat");
  std::string text;
  std::getline(file, text, '\0');
  // The name is in parentheses, and may have any characters, also ends of lines.
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  Process process;
  char state = 0;
  double ticks[4] = {};  // user and system time, then those of its children
  const int read = std::sscanf(text.c_str() + name_end,
                               ") %c %d %*s %*s %*s %*s %*s %*s %*s %*s %*s %lf %lf %lf %lf",
                               &state, &process.parent, &ticks[0], &ticks[1], &ticks[2], &ticks[3]);
  if (read != 6) return std::nullopt;
  process.is_runnable = state == 'R' || state == 'D';
  process.seconds =
      (ticks[0] + ticks[1] + ticks[2] + ticks[3]) / static_cast<double>(sysconf(_SC_CLK_TCK));
  return process;
}

std::map<pid_t, Process> all_processes() {
  std::map<pid_t, Process> processes;
  std::error_code error;
  for (std::filesystem::directory_iterator at("/proc", error), end; !error && at != end;
       at.increment(error)) {
    const pid_t pid = std::atoi(at->path().filename().c_str());  // 0: it is no process
    const auto process = pid > 0 ? read_process(at->path()) : std::nullopt;
    if (process) processes[pid] = *process;
  }
  return processes;
}

}  // namespace

std::map<pid_t, TreeUse> use_of_trees(const std::vector<pid_t>& roots) {
  std::map<pid_t, TreeUse> uses;
  for (const pid_t root : roots) uses[root] = {};
  const auto processes = all_processes();
  for (const auto& [pid, process] : processes) {
    // The list is not of one moment, so the way up has an end of its own.
    pid_t above = pid;
    for (std::size_t i = 0; i < processes.size() && !uses.contains(above); ++i) {
      const auto found = processes.find(above);
      if (found == processes.end()) break;
      above = found->second.parent;
    }
    const auto root = uses.find(above);
    if (root == uses.end()) continue;
    root->second.seconds += process.seconds;
    root->second.is_runnable = root->second.is_runnable || process.is_runnable;
  }
  return uses;
}

}  // namespace mirocup::system
