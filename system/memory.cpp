// SPDX-License-Identifier: MIT
#include "system/memory.hpp"

#include <algorithm>
#include <fstream>

namespace mirocup::system {

namespace {

// Returns the number that follows the word in a file of words and numbers.
std::optional<std::uint64_t> number_after(const std::string& file, const std::string& word) {
  std::ifstream in(file);
  std::string found;
  std::uint64_t number = 0;
  while (in >> found) {
    if (found == word && in >> number) return number;
  }
  return std::nullopt;
}

std::optional<std::uint64_t> number_in(const std::string& file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  if (!(in >> number)) return std::nullopt;  // also for "max"
  return number;
}

// The names of one version of control groups.
struct GroupFiles {
  std::string mount;
  const char* limit;
  const char* usage;
  const char* cached[2];  // in memory.stat: pages of files, which the kernel can drop
};

// Returns the room in that group and in those around it.
std::optional<std::size_t> room_in_groups(const GroupFiles& files, std::string group) {
  std::optional<std::size_t> least;
  while (true) {
    const std::string folder = files.mount + group + "/";
    const auto limit = number_in(folder + files.limit);
    const auto usage = number_in(folder + files.usage);
    if (limit && usage) {
      std::uint64_t used = *usage;
      for (const char* key : files.cached)
        used -= std::min(used, number_after(folder + "memory.stat", key).value_or(0));
      const std::size_t room = *limit - std::min(*limit, used);
      least = std::min(least.value_or(room), room);
    }
    const auto slash = group.rfind('/');
    if (slash == std::string::npos) return least;
    group.erase(slash);
  }
}

// Returns the room of the memory groups of this process. A line of /proc/self/cgroup is
// "number:controllers:path"; the second version has the number 0 and no controllers.
std::optional<std::size_t> room_in_groups(const std::string& root) {
  std::ifstream in(root + "/proc/self/cgroup");
  std::optional<std::size_t> least;
  const auto take = [&least](std::optional<std::size_t> room) {
    if (room) least = std::min(least.value_or(*room), *room);
  };
  const std::string mounts = root + "/sys/fs/cgroup";
  for (std::string line; std::getline(in, line);) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    std::string group = line.substr(second + 1);
    if (group == "/") group.clear();
    if (controllers == ",,") {
      for (const char* mount : {"", "/unified"}) {
        take(room_in_groups(
            {mounts + mount, "memory.max", "memory.current", {"inactive_file", "active_file"}},
            group));
      }
    } else if (controllers.find(",memory,") != std::string::npos) {
      take(room_in_groups({mounts + "/memory",
                           "memory.limit_in_bytes",
                           "memory.usage_in_bytes",
                           {"total_inactive_file", "total_active_file"}},
                          group));
    }
  }
  return least;
}

}  // namespace

std::optional<std::size_t> available_memory(const std::string& root) {
  const auto kibibytes = number_after(root + "/proc/meminfo", "MemAvailable:");
  if (!kibibytes) return std::nullopt;
  const std::size_t available = *kibibytes << 10;
  return std::min(available, room_in_groups(root).value_or(available));
}

std::optional<std::uint64_t> out_of_memory_kills(const std::string& root) {
  return number_after(root + "/proc/vmstat", "oom_kill");
}

std::string mebibytes(std::size_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

}  // namespace mirocup::system
