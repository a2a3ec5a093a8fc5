// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/probe.hpp"

#include "plugins/host/sandbox/file_access.hpp"
#include "plugins/host/sandbox/fork.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "system/descriptor.hpp"

#include <algorithm>
#include <array>
#include <fcntl.h>
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

// What helps where a step of T2 is refused; docs/installing.md has it for each kind of container.
const char* cure_of(const Error& refused) {
  const bool is_user = refused.what.find("separate user") != std::string::npos;
  if (is_user && geteuid() == 0) return "run it as another user, in a container by --user 1000";
  return "a container needs a profile that allows it, see docs/installing.md; elsewhere an "
         "administrator can allow user namespaces";
}

// In the child: tells the parent which step was refused.
[[noreturn]] void enter_root_and_report(int to) {
  if (const char* step = enter_private_root(no_entry)) give_up(to, step);
  _exit(0);
}

// Returns what the child said, "" if each step was taken.
Result<std::string> try_namespaces() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return fail(Errc::unavailable, "a pipe cannot be made");
  const system::Descriptor from(ends[0]);
  system::Descriptor to(ends[1]);
  MIROCUP_TRY(const auto pid,
              fork_isolated(Isolation::T2, [&] { enter_root_and_report(to.get()); }));
  to.reset();
  std::array<char, 200> text{};
  const ssize_t length = read(from.get(), text.data(), text.size());
  int status = 0;
  TEMP_FAILURE_RETRY(waitpid(pid, &status, 0));
  if (length <= 0 && status != 0)
    return fail(Errc::unavailable, "the process that tried to make a separate root folder died");
  return std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
}

}  // namespace

std::string why_no_t2() {
  auto refused = try_namespaces();
  // A child that somebody killed, as a full memory does, has not said that the system refuses a
  // step, and a leg would be played in the lower tier for it: others try, too.
  for (int more = 2; !refused && more > 0; --more) refused = try_namespaces();
  if (refused && !refused->empty()) refused = fail(Errc::unavailable, *refused);
  if (refused) return "";
  return refused.error().what + " (" + cure_of(refused.error()) + ")";
}

Result<Isolation> strongest_isolation() {
  const char* advice =
      ". Strategies are not run without it; --trusted runs them unprotected, in this process";
  if (!can_trap_system_calls())
    return fail(
        Errc::unavailable,
        std::string("this system has no seccomp, which keeps strategies from harm") + advice);
  if (landlock_version() < 1)
    return fail(Errc::unavailable,
                std::string("this kernel has no Landlock (Linux 5.13), which keeps strategies from "
                            "files") +
                    advice);
  return why_no_t2().empty() ? Isolation::T2 : Isolation::T1;
}

}  // namespace mirocup::plugins
