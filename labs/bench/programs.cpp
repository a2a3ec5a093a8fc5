// SPDX-License-Identifier: MIT
#include "labs/bench/programs.hpp"

#include <chrono>
#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::bench {

namespace {

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

// The kernel leaves out cores that do not exist.
void go_to_any_core() {
  cpu_set_t all;
  CPU_ZERO(&all);
  for (int core = 0; core < CPU_SETSIZE; ++core) CPU_SET(core, &all);
  sched_setaffinity(0, sizeof all, &all);
}

}  // namespace

std::optional<ProgramTimes> run(std::vector<std::string> words, Cores cores) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = fork();
  if (pid == 0) {
    if (cores == Cores::all) go_to_any_core();
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (pid < 0 || wait4(pid, &status, 0, &used) != pid || status != 0) return std::nullopt;
  ProgramTimes times;
  times.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  times.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  return times;
}

}  // namespace mirocup::bench
