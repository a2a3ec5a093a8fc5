// SPDX-License-Identifier: MIT
#include "system/child_process.hpp"

#include "system/descriptor.hpp"
#include "system/links.hpp"
#include "system/process_set.hpp"

#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::system {

namespace {

// Pointers into `words`, with the null that ends them, as exec wants them.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Opens the file that a child writes to, empty. A file that another user has put there, by a link
// or by a second name of a file of ours, is refused and keeps its bytes.
Result<Descriptor> open_log(const std::string& path) {
  constexpr int flags = O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  MIROCUP_TRY(const auto way, way_to(path, "written"));
  Descriptor log(open(way.path.c_str(), flags, 0644));
  struct stat about {};
  if (!log.is_open() || fstat(log.get(), &about) != 0)
    return fail(Errc::unavailable, path + " cannot be written: " + std::strerror(errno));
  if (S_ISREG(about.st_mode) && (about.st_uid != geteuid() || about.st_nlink > 1))
    return fail(Errc::unavailable, path + " cannot be written: another user has put a file there");
  if (S_ISREG(about.st_mode) && ftruncate(log.get(), 0) != 0)
    return fail(Errc::unavailable, path + " cannot be written: " + std::strerror(errno));
  if (!S_ISREG(about.st_mode) && !S_ISCHR(about.st_mode))
    return fail(Errc::unavailable, path + " cannot be written: it is not a regular file");
  return log;
}

// In the child, between fork and exec: only functions that are safe there if there are threads.
[[noreturn]] void become_child(char* const* arguments, int cpu, int log, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(not_found);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (cpu >= 0) stay_on(cpu);
  if (log >= 0) {
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
  }
  close_range(3, ~0U, 0);
  execvp(arguments[0], arguments);
  _exit(not_found);
}

}  // namespace

Result<pid_t> start_child(const ChildOptions& options) {
  assert(!options.arguments.empty());
  std::vector<std::string> words = options.arguments;
  const std::vector<char*> arguments = pointers_to(words);
  Descriptor log;
  if (!options.log.empty()) {
    MIROCUP_TRY(log, open_log(options.log));
  }
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become_child(arguments.data(), options.cpu, log.get(), parent);
  if (pid > 0) return pid;
  return fail(Errc::unavailable,
              std::string("a process cannot be started: ") + std::strerror(errno));
}

Result<int> run_child(const ChildOptions& options) {
  MIROCUP_TRY(const auto pid, start_child(options));
  int status = 0;
  while (waitpid(pid, &status, 0) < 0) {
    if (errno == EINTR) continue;
    return fail(Errc::unavailable,
                options.arguments[0] + " cannot be waited for: " + std::strerror(errno));
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

Error become_program(std::vector<std::string> arguments) {
  assert(!arguments.empty());
  execv(arguments[0].c_str(), pointers_to(arguments).data());
  return {Errc::unavailable, arguments[0] + " cannot be run: " + std::strerror(errno)};
}

}  // namespace mirocup::system
