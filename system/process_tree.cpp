// SPDX-License-Identifier: MIT
#include "system/process_tree.hpp"

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
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
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  // The name is in parentheses, and may have any characters.
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(name_end + 1));
  Process process;
  std::string state, skipped;
  fields >> state >> process.parent;
  process.is_runnable = state == "R" || state == "D";
  for (int i = 0; i < 9; ++i) fields >> skipped;
  std::array<double, 4> ticks{};  // user and system time, then those of its children
  for (double& tick : ticks) fields >> tick;
  if (!fields) return std::nullopt;
  const auto per_second = static_cast<double>(sysconf(_SC_CLK_TCK));
  process.seconds = (ticks[0] + ticks[1] + ticks[2] + ticks[3]) / per_second;
  return process;
}

std::map<pid_t, Process> all_processes() {
  std::map<pid_t, Process> processes;
  std::error_code error;
  for (std::filesystem::directory_iterator at("/proc", error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename();
    pid_t pid = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), pid);
    if (read.ec != std::errc() || read.ptr != name.data() + name.size()) continue;
    if (const auto process = read_process(at->path())) processes[pid] = *process;
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
