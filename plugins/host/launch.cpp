// SPDX-License-Identifier: MIT
#include "plugins/host/launch.hpp"

#include "plugins/host/sandbox/fork.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "system/descriptor.hpp"

#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <sys/personality.h>
#include <sys/stat.h>

namespace mirocup::plugins {

namespace {

// The environment is fixed, so that nothing of the server's reaches a team. OpenMP and OpenBLAS get
// one thread, because a team has no more.
const char* const environment[] = {"LANG=C", "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1",
                                   nullptr};

// Gives the descriptors the numbers that the host program expects and closes all others.
bool arrange_descriptors(const Launch& what, int program) {
  const int nothing = open("/dev/null", O_RDONLY);
  const int from[] = {nothing,      what.log,   what.log,   what.observation,
                      what.command, what.setup, what.entry, program};
  static_assert(std::size(from) == program_descriptor + 1);
  return take_descriptors(from) && fcntl(program_descriptor, F_SETFD, FD_CLOEXEC) == 0;
}

// Restores the default handlers, because exec keeps ignored signals. All signals are blocked until
// the host program has its own handlers (report_faults_to): one that is sent to all processes of a
// job while a team starts must not end the team.
void hold_signals() {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
}

[[noreturn]] void become_host(const Launch& what, int program) {
  // In a session of its own a team cannot reach the server with a signal to its process group.
  setsid();
  hold_signals();
  umask(077);
  // The same addresses in every leg: one source of randomness less.
  if (what.fixed_addresses) personality(ADDR_NO_RANDOMIZE);
  if (!arrange_descriptors(what, program)) give_up(what.setup, "descriptors");
  const bool has_namespaces = what.isolation == Isolation::T2;
  if (has_namespaces) {
    if (const char* step = enter_private_root(entry_descriptor)) give_up(setup_descriptor, step);
  } else if (chdir("/") != 0) {
    give_up(setup_descriptor, "the root folder");
  }
  // The host program learns from its argument what surrounds it.
  char name[] = "mirocup-team";
  char inner[] = "T2";
  char outer[] = "T1";
  char* arguments[] = {name, has_namespaces ? inner : outer, nullptr};
  execveat(program_descriptor, "", arguments, const_cast<char* const*>(environment), AT_EMPTY_PATH);
  give_up(setup_descriptor, "the start of the team's program");
}

}  // namespace

Result<Child> launch(const Launch& what) {
  assert(what.isolation != Isolation::none);
  // Opened by the parent, because the child's user may not be able to reach it by its path.
  const system::Descriptor program(open(what.program.c_str(), O_PATH | O_CLOEXEC));
  if (program.get() < 0)
    return fail(Errc::unavailable, what.program + " cannot be run: " + std::strerror(errno));
  MIROCUP_TRY(auto pid, fork_isolated(what.isolation, [&] { become_host(what, program.get()); }));
  return Child(pid);
}

}  // namespace mirocup::plugins
