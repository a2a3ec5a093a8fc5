// SPDX-License-Identifier: MIT
#include "plugins/host/child.hpp"

#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <utility>

namespace mirocup::plugins {

namespace {

ExitStatus to_exit_status(int status) {
  return WIFSIGNALED(status) ? ExitStatus{.exit_code = 0, .signal = WTERMSIG(status)}
                             : ExitStatus{.exit_code = WEXITSTATUS(status), .signal = 0};
}

}  // namespace

std::string signal_text(int signal) {
  return "signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
}

Child::Child(pid_t pid) : pid_(pid) {
  assert(pid > 0);
  clock_getcpuclockid(pid, &cpu_clock_);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      cpu_clock_(other.cpu_clock_),
      cpu_(other.cpu_),
      peak_memory_(other.peak_memory_),
      exit_status_(other.exit_status_) {}

Child::~Child() {
  if (pid_ > 0) kill();
}

std::optional<ExitStatus> Child::exit_status() {
  if (!exit_status_) reap(WNOHANG);
  return exit_status_;
}

void Child::kill() {
  if (exit_status_) return;
  peak_memory_ = peak_memory();
  ::kill(pid_, SIGKILL);
  if (!reap(0)) exit_status_ = ExitStatus{};
}

// Takes the exit status and the peak of memory of a process that has ended. Returns false if it has
// not.
bool Child::reap(int options) {
  int status = 0;
  rusage usage{};
  if (TEMP_FAILURE_RETRY(wait4(pid_, &status, options, &usage)) != pid_) return false;
  exit_status_ = to_exit_status(status);
  // The kernel's figure counts the copy of the server that the process was before exec, too.
  if (peak_memory_ == 0) peak_memory_ = static_cast<std::size_t>(usage.ru_maxrss) << 10;
  return true;
}

double Child::cpu_seconds() {
  timespec t{};
  if (!exit_status_ && clock_gettime(cpu_clock_, &t) == 0)
    cpu_ = static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  return cpu_;
}

std::optional<double> Child::processor_delay(pid_t pid) {
  std::ifstream statistics("/proc/" + std::to_string(pid) + "/schedstat");
  double run_ns = 0.0;
  double delay_ns = 0.0;
  if (!(statistics >> run_ns >> delay_ns)) return std::nullopt;
  return 1e-9 * delay_ns;
}

std::size_t Child::peak_memory() const {
  if (exit_status_) return peak_memory_;
  std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
  std::string key;
  std::size_t kibibytes = 0;
  while (status >> key) {
    if (key == "VmHWM:" && status >> kibibytes) return kibibytes << 10;
  }
  return 0;
}

}  // namespace mirocup::plugins
