// SPDX-License-Identifier: MIT
#include "system/child_process.hpp"

#include "system/descriptor.hpp"
#include "system/files.hpp"
#include "system/links.hpp"
#include "system/locations.hpp"
#include "system/process_set.hpp"
#include "system/text.hpp"

#include <cassert>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
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
[[noreturn]] void become_child(char* const* arguments, const ChildOptions& options, int log,
                               pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(not_found);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (options.cpu >= 0) stay_on(options.cpu);
  const rlimit most{options.max_bytes, options.max_bytes};
  if (options.max_bytes < ChildLimits().bytes) setrlimit(RLIMIT_FSIZE, &most);
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

// `log`: the descriptor for its output and errors, which makes it lead a group; -1: as a child
// without a log.
Result<pid_t> start_with(const ChildOptions& options, int log) {
  assert(!options.arguments.empty());
  std::vector<std::string> words = options.arguments;
  const std::vector<char*> arguments = pointers_to(words);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become_child(arguments.data(), options, log, parent);
  if (pid > 0) return pid;
  return fail(Errc::unavailable,
              std::string("a process cannot be started: ") + std::strerror(errno));
}

int wait_for(pid_t pid) {
  int status = not_found << 8;  // if the system does not tell it
  TEMP_FAILURE_RETRY(waitpid(pid, &status, 0));
  return status;
}

int code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

Result<pid_t> start_child(const ChildOptions& options) {
  Descriptor log;
  if (!options.log.empty()) {
    MIROCUP_TRY(log, open_log(options.log));
  }
  return start_with(options, log.get());
}

Result<int> run_child(const ChildOptions& options) {
  MIROCUP_TRY(const auto pid, start_child(options));
  return code_of(wait_for(pid));
}

Result<Answer> ask(const std::vector<std::string>& arguments, const ChildLimits& limits) {
  const Descriptor output(memfd_create("answer", MFD_CLOEXEC));
  if (!output.is_open())
    return fail(Errc::unavailable, std::string("memory for an answer: ") + std::strerror(errno));
  MIROCUP_TRY(const auto pid,
              start_with({.arguments = arguments, .max_bytes = limits.bytes}, output.get()));
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limits.seconds);
  constexpr int look_interval = 5;  // ms
  while (!has_ended(pid) && std::chrono::steady_clock::now() < end) poll(nullptr, 0, look_interval);
  const bool is_in_time = has_ended(pid);
  const int code = code_of(end_group(pid));
  if (!is_in_time)
    return fail(
        Errc::unavailable,
        arguments[0] + formatted(" has not ended after %g s and was stopped", limits.seconds));
  return Disk()
      .read("/proc/self/fd/" + std::to_string(output.get()),
            {.max_size = limits.bytes, .links = Links::followed, .growth = Growth::ignored})
      .map([code](std::string text) {
        return Answer{code, std::move(text)};
      });
}

bool has_ended(pid_t pid) {
  siginfo_t about{};
  return waitid(P_PID, static_cast<id_t>(pid), &about, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         about.si_pid == pid;
}

int end_group(pid_t leader) {
  kill(-leader, SIGKILL);
  kill(leader, SIGKILL);  // it may not lead its group yet
  return wait_for(leader);
}

Error become_program(std::vector<std::string> arguments) {
  assert(!arguments.empty());
  execv(arguments[0].c_str(), pointers_to(arguments).data());
  return {Errc::unavailable, arguments[0] + " cannot be run: " + std::strerror(errno)};
}

Error become_sibling_program(const std::string& name, std::vector<std::string> arguments,
                             const std::string& options) {
  const std::string program = sibling_program(name);
  if (access(program.c_str(), F_OK) != 0) {
    const std::string build = shell_word(build_folder());
    return {Errc::unavailable,
            name + ": this program is not built; cmake " + (options.empty() ? "" : options + " ") +
                build + " && cmake --build " + build + " --target " + name + " builds it"};
  }
  arguments.insert(arguments.begin(), program);
  return become_program(std::move(arguments));
}

}  // namespace mirocup::system
