// SPDX-License-Identifier: MIT
#include "system/process_set.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <sched.h>
#include <sys/wait.h>

namespace mirocup::system {

namespace {

sigset_t awaited_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&set, signal);
  return set;
}

// Returns the first awaited signal within this time, s; a negative number if none comes.
int next_signal(double seconds) {
  const sigset_t set = awaited_signals();
  const auto ns = static_cast<std::int64_t>(1e9 * std::max(seconds, 0.0));
  const timespec timeout{ns / 1'000'000'000, ns % 1'000'000'000};
  return sigtimedwait(&set, nullptr, &timeout);
}

bool asks_to_stop(int signal) {
  return signal == SIGINT || signal == SIGTERM;
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
                                const std::string& log, const ChildLimits& limits) {
  const auto pid =
      start_child({.arguments = arguments, .cpu = cpu, .log = log, .max_bytes = limits.bytes});
  const std::chrono::duration<double> time(limits.seconds);
  if (pid)
    children_.push_back({.pid = *pid, .tag = tag, .end = std::chrono::steady_clock::now() + time});
  return pid;
}

std::optional<Exit> ProcessSet::ended() {
  for (auto child = children_.begin(); child != children_.end(); ++child) {
    if (!has_ended(child->pid) && std::chrono::steady_clock::now() < child->end) continue;
    const int status = end_group(child->pid);
    Exit exit{.tag = child->tag};
    if (WIFSIGNALED(status)) {
      exit.signal = WTERMSIG(status);
    } else {
      exit.code = WEXITSTATUS(status);
    }
    children_.erase(child);
    return exit;
  }
  return std::nullopt;
}

std::optional<Exit> ProcessSet::wait() {
  assert(!children_.empty());
  constexpr double look_interval = 1.0;  // s, for a child whose time is over
  while (true) {
    if (const auto exit = ended()) return exit;
    if (asks_to_stop(next_signal(look_interval))) return std::nullopt;
  }
}

ProcessSet::News ProcessSet::wait_within(double seconds) {
  if (const auto exit = ended()) return {exit, false};
  const bool is_asked_to_stop = asks_to_stop(next_signal(seconds));
  return {ended(), is_asked_to_stop};
}

bool ProcessSet::is_asked_to_stop_within(double seconds) {
  using std::chrono::steady_clock;
  const std::chrono::duration<double> time(seconds);
  const auto end = steady_clock::now() + time;
  for (auto rest = time;; rest = end - steady_clock::now()) {
    const int signal = next_signal(rest.count());
    if (signal < 0 && errno == EAGAIN) return false;
    if (asks_to_stop(signal)) return true;
  }
}

void ProcessSet::kill(pid_t pid) {
  const auto found = std::find_if(children_.begin(), children_.end(),
                                  [pid](const Running& r) { return r.pid == pid; });
  if (found == children_.end()) return;
  end_group(pid);
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

void stay_on(int processor) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(processor, &one);
  sched_setaffinity(0, sizeof one, &one);
}

}  // namespace mirocup::system
