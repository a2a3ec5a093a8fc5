// SPDX-License-Identifier: MIT
//
// Reads kept inputs: fuzz_corpus FOLDER, with FOLDER/READER/FILE. Each is read in a process of its
// own, which may take 2 s of processor time and 512 MB. Exits with 1 if one took more or ended in
// another way than by itself, and with 2 if there is nothing to read.
#include "tests/security/fuzz/fuzz_target.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

#ifdef MIROCUP_SANITIZED
constexpr double max_seconds = 20.0;  // sanitizers look for errors, the release build at the costs
#else
constexpr double max_seconds = 2.0;
#endif
constexpr double max_megabytes = 512.0;
constexpr rlim_t hang_seconds = 20;  // of processor time; then it is stopped

struct Cost {
  bool is_well = false;
  double seconds = 0.0;
  double megabytes = 0.0;
};

Cost cost_of(mirocup::fuzz::Reader read, const std::filesystem::path& path) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{hang_seconds, hang_seconds};
    setrlimit(RLIMIT_CPU, &limit);
    std::ifstream in(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    read(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) return {};
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {.is_well = WIFEXITED(status) && WEXITSTATUS(status) == 0,
          .seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
          .megabytes = double(usage.ru_maxrss) / 1024.0};
}

}  // namespace

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  if (argc != 2) return 2;
  int total = 0;
  int bad = 0;
  for (const auto& [name, read] : mirocup::fuzz::readers()) {
    Cost most;
    int count = 0;
    std::error_code none;
    for (const auto& file : fs::directory_iterator(fs::path(argv[1]) / name, none)) {
      const Cost cost = cost_of(read, file.path());
      ++count;
      most.seconds = std::max(most.seconds, cost.seconds);
      most.megabytes = std::max(most.megabytes, cost.megabytes);
      if (cost.is_well && cost.seconds <= max_seconds && cost.megabytes <= max_megabytes) continue;
      ++bad;
      std::printf("%s: %s, %.2f s, %.0f MB\n", file.path().c_str(),
                  cost.is_well ? "read" : "crashed or stopped", cost.seconds, cost.megabytes);
    }
    std::printf("%s: %d inputs, at most %.2f s and %.0f MB\n", name.c_str(), count, most.seconds,
                most.megabytes);
    total += count;
  }
  return bad > 0 ? 1 : total > 0 ? 0 : 2;
}
