// SPDX-License-Identifier: MIT
#include "plugins/host/child.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

// Fixed, so that nothing of the server's surroundings reaches a team. One thread for those who use
// OpenMP.
const char* const environment[] = {"LANG=C", "OMP_NUM_THREADS=1",
                                   "ASAN_OPTIONS=detect_leaks=0:handle_segv=0", nullptr};

// Between fork and exec: only calls that are safe there. `keep` is sorted.
[[noreturn]] void become(const char* program, char* const* arguments, const int* keep, int kept,
                         int output, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent died before the line above
  setsid();
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);

  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  unsigned first = 3;
  for (int i = 0; i < kept; ++i) {
    if (static_cast<unsigned>(keep[i]) > first) close_range(first, keep[i] - 1, 0);
    fcntl(keep[i], F_SETFD, 0);
    first = keep[i] + 1;
  }
  close_range(first, ~0U, 0);

  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execve(program, arguments, const_cast<char* const*>(environment));
  _exit(127);
}

}  // namespace

std::string Ending::text() const {
  if (signal == 0) return "ended itself with exit code " + std::to_string(exit_code);
  return "died of signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
}

Result<Child> Child::start(const std::string& program, const std::vector<std::string>& arguments,
                           const std::vector<int>& descriptors, int output) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::vector<int> keep = descriptors;
  std::sort(keep.begin(), keep.end());

  if (access(program.c_str(), X_OK) != 0) {
    return fail(Errc::unavailable, program + " cannot be run: " + std::strerror(errno));
  }
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) {
    return fail(Errc::unavailable,
                std::string("a process cannot be started: ") + std::strerror(errno));
  }
  if (pid == 0) {
    become(program.c_str(), argv.data(), keep.data(), static_cast<int>(keep.size()), output,
           parent);
  }
  return Child(pid);
}

Child::Child(pid_t pid) : pid_(pid) {
  clock_getcpuclockid(pid, &cpu_clock_);
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      cpu_clock_(other.cpu_clock_),
      ending_(std::move(other.ending_)) {}

Child::~Child() {
  if (pid_ > 0) kill();
}

std::optional<Ending> Child::ending() {
  if (ending_) return ending_;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
  ending_ = WIFSIGNALED(status) ? Ending{0, WTERMSIG(status)} : Ending{WEXITSTATUS(status), 0};
  return ending_;
}

void Child::kill() {
  if (!ending_) {
    ::kill(pid_, SIGKILL);
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    ending_ = WIFSIGNALED(status) ? Ending{0, WTERMSIG(status)} : Ending{WEXITSTATUS(status), 0};
  }
}

double Child::cpu_seconds() const {
  timespec t{};
  if (clock_gettime(cpu_clock_, &t) != 0) return 0.0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace mirocup::plugins
