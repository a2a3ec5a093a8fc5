// SPDX-License-Identifier: MIT
#include "server/system/process_set.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::system {

namespace {

sigset_t awaited_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&set, signal);
  return set;
}

[[noreturn]] void become(char* const* arguments, int cpu, const char* log, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(not_found);
  setpgid(0, 0);  // an interrupt at the terminal is for the league to pass on
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (cpu >= 0) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  const int nothing = open("/dev/null", O_RDONLY);
  const int out = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  close_range(3, ~0U, 0);
  execvp(arguments[0], arguments);
  _exit(not_found);
}

}  // namespace

ProcessSet::ProcessSet() {
  const sigset_t set = awaited_signals();
  sigprocmask(SIG_BLOCK, &set, nullptr);
}

ProcessSet::~ProcessSet() {
  while (!children_.empty()) kill(children_.back().pid);
}

Result<pid_t> ProcessSet::start(const std::vector<std::string>& arguments, int tag, int cpu,
                                const std::string& log) {
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) {
    return fail(Errc::unavailable,
                std::string("a process cannot be started: ") + std::strerror(errno));
  }
  if (pid == 0) become(argv.data(), cpu, log.c_str(), parent);
  children_.push_back({pid, tag});
  return pid;
}

std::optional<Exit> ProcessSet::wait() {
  const sigset_t set = awaited_signals();
  while (true) {
    for (auto child = children_.begin(); child != children_.end(); ++child) {
      int status = 0;
      if (waitpid(child->pid, &status, WNOHANG) != child->pid) continue;
      Exit exit{child->tag, 0, 0};
      if (WIFSIGNALED(status)) {
        exit.signal = WTERMSIG(status);
      } else {
        exit.code = WEXITSTATUS(status);
      }
      children_.erase(child);
      return exit;
    }
    const int signal = sigwaitinfo(&set, nullptr);
    if (signal == SIGINT || signal == SIGTERM) return std::nullopt;
  }
}

bool ProcessSet::is_asked_to_stop_within(double seconds) {
  using Clock = std::chrono::steady_clock;
  const sigset_t set = awaited_signals();
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(end - Clock::now());
    const std::int64_t patience = std::max<std::int64_t>(left.count(), 0);
    const timespec timeout{patience / 1'000'000'000, patience % 1'000'000'000};
    const int signal = sigtimedwait(&set, nullptr, &timeout);
    if (signal == SIGINT || signal == SIGTERM) return true;
    if (signal < 0 && errno == EAGAIN) return false;
  }
}

void ProcessSet::kill(pid_t pid) {
  const auto found = std::find_if(children_.begin(), children_.end(),
                                  [pid](const Running& r) { return r.pid == pid; });
  if (found == children_.end()) return;
  ::kill(pid, SIGKILL);
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
  children_.erase(found);
}

std::vector<int> processors() {
  cpu_set_t mask;
  std::vector<int> list;
  if (sched_getaffinity(0, sizeof mask, &mask) != 0) return {-1};
  for (int i = 0; i < CPU_SETSIZE; ++i) {
    if (CPU_ISSET(i, &mask)) list.push_back(i);
  }
  return list;
}

}  // namespace mirocup::system
