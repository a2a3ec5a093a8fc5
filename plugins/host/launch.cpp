// SPDX-License-Identifier: MIT
#include "plugins/host/launch.hpp"

#include "plugins/host/descriptor.hpp"
#include "plugins/host/sandbox/fork.hpp"
#include "plugins/host/sandbox/private_root.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/personality.h>
#include <sys/stat.h>

namespace mirocup::plugins {

namespace {

// Fixed, so that nothing of the server's surroundings reaches a team. One thread for those who use
// OpenMP or OpenBLAS.
const char* const environment[] = {"LANG=C", "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1",
                                   nullptr};

// Above all numbers that descriptors are given in the end.
constexpr int first_spare = 16;

// Between fork and exec: only calls that are safe there.
[[noreturn]] void give_up(int setup, const char* step) {
  const char* why = strerrorname_np(errno);
  (void)!write(setup, step, std::strlen(step));
  (void)!write(setup, ": ", 2);
  if (why != nullptr) (void)!write(setup, why, std::strlen(why));
  _exit(127);
}

// Puts the descriptors where the host program looks for them and closes all others.
bool arrange_descriptors(const Launch& what, int program) {
  const int nothing = open("/dev/null", O_RDONLY);
  const int from[] = {nothing,      what.log,   what.log,   what.observation,
                      what.command, what.setup, what.entry, program};
  constexpr int count = sizeof from / sizeof from[0];
  static_assert(count == program_descriptor + 1);
  int spare[count];
  for (int i = 0; i < count; ++i) {
    spare[i] = fcntl(from[i], F_DUPFD, first_spare);
    if (spare[i] < 0) return false;
  }
  for (int i = 0; i < count; ++i) {
    if (dup2(spare[i], i) < 0) return false;
  }
  return close_range(count, ~0U, 0) == 0 && fcntl(program_descriptor, F_SETFD, FD_CLOEXEC) == 0;
}

// Signals as a program finds them that nobody started in a special way.
void reset_signals() {
  for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_host(const Launch& what, int program) {
  // A session of its own: signals to "my group" do not reach the server.
  setsid();
  reset_signals();
  umask(077);
  // The same addresses in every leg: one source of chance less.
  personality(ADDR_NO_RANDOMIZE);
  if (!arrange_descriptors(what, program)) give_up(what.setup, "descriptors");
  const bool is_inner = what.isolation == Isolation::T2;
  if (is_inner) {
    if (const char* step = enter_private_root(entry_descriptor)) give_up(setup_descriptor, step);
  } else if (chdir("/") != 0) {
    give_up(setup_descriptor, "the root folder");
  }
  // The host program tells what it finds from its argument.
  char name[] = "mirocup-plugin-host";
  char inner[] = "T2";
  char outer[] = "T1";
  char* arguments[] = {name, is_inner ? inner : outer, nullptr};
  execveat(program_descriptor, "", arguments, const_cast<char* const*>(environment), AT_EMPTY_PATH);
  give_up(setup_descriptor, "the start of mirocup-plugin-host");
}

}  // namespace

Result<Child> launch(const Launch& what) {
  // Opened here: the other user may not be able to reach it by its path.
  const Descriptor program(open(what.program.c_str(), O_PATH | O_CLOEXEC));
  if (program.get() < 0)
    return fail(Errc::unavailable, what.program + " cannot be run: " + std::strerror(errno));
  auto pid = fork_isolated(what.isolation, [&] { become_host(what, program.get()); });
  if (!pid) return tl::unexpected(pid.error());
  return Child(*pid);
}

}  // namespace mirocup::plugins
