// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/probe.hpp"

#include "plugins/host/sandbox/file_access.hpp"
#include "plugins/host/sandbox/fork.hpp"
#include "plugins/host/sandbox/private_root.hpp"

#include <cerrno>
#include <linux/seccomp.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::plugins {

namespace {

bool can_trap_system_calls() {
  const unsigned action = SECCOMP_RET_TRAP;
  return syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

bool can_have_namespaces() {
  const auto pid =
      fork_isolated(Isolation::T2, [] { _exit(enter_private_root(no_entry) == nullptr ? 0 : 1); });
  if (!pid) return false;
  int status = 0;
  while (waitpid(*pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Result<Isolation> strongest_isolation() {
  const char* advice =
      ". Strategies are not run without it; --trusted runs them unprotected, in this process";
  if (!can_trap_system_calls()) {
    return fail(
        Errc::unavailable,
        std::string("this system has no seccomp, which keeps strategies from harm") + advice);
  }
  if (landlock_version() < 1) {
    return fail(Errc::unavailable,
                std::string("this kernel has no Landlock (Linux 5.13), which keeps strategies from "
                            "files") +
                    advice);
  }
  return can_have_namespaces() ? Isolation::T2 : Isolation::T1;
}

}  // namespace mirocup::plugins
