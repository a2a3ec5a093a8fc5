// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/fork.hpp"

#include "plugins/host/descriptor.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <grp.h>
#include <linux/securebits.h>
#include <sched.h>
#include <string>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>

namespace mirocup::plugins {

namespace {

// What a team's process calls itself in its own namespace.
constexpr uid_t inner_user = 1000;

// Outside, if the server is root: users that own nothing, one for each process, so that limits and
// signals of one team reach no other.
constexpr uid_t first_outer_user = 61000;
constexpr uid_t outer_users = 1000;

uid_t outer_user(pid_t pid) {
  return first_outer_user + static_cast<uid_t>(pid) % outer_users;
}

bool write_to(const std::string& path, const std::string& text) {
  const Descriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  return write(file.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

// Maps one user and one group of the child's namespace to one outside.
bool write_id_maps(pid_t pid) {
  const std::string folder = "/proc/" + std::to_string(pid) + "/";
  if (!write_to(folder + "setgroups", "deny")) return false;
  const auto map_to = [&](uid_t user, gid_t group) {
    const std::string inner = std::to_string(inner_user) + " ";
    return write_to(folder + "gid_map", inner + std::to_string(group) + " 1\n") &&
           write_to(folder + "uid_map", inner + std::to_string(user) + " 1\n");
  };
  // Root of a container may not have the other users.
  if (geteuid() == 0 && map_to(outer_user(pid), outer_user(pid))) return true;
  return map_to(geteuid(), getegid());
}

}  // namespace

Result<pid_t> fork_isolated(Isolation isolation, const std::function<void()>& run) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return fail(Errc::unavailable, std::string("a pipe cannot be made: ") + std::strerror(errno));
  Descriptor wait_end(ends[0]);
  Descriptor go_end(ends[1]);
  const int namespaces = CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWIPC |
                         CLONE_NEWUTS | CLONE_NEWCGROUP;
  const long flags = SIGCHLD | (isolation == Isolation::T2 ? namespaces : 0);
  const auto pid = static_cast<pid_t>(syscall(SYS_clone, flags, 0, 0, 0, 0));
  if (pid < 0) {
    return fail(Errc::unavailable,
                std::string("a process cannot be started: ") + std::strerror(errno));
  }
  if (pid == 0) {
    go_end.reset();
    char go = 0;
    if (read(wait_end.get(), &go, 1) != 1) _exit(127);
    run();
    _exit(127);
  }
  if (isolation == Isolation::T2 && !write_id_maps(pid)) {
    const int why = errno;
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
    return fail(Errc::unavailable,
                std::string("the users of a namespace cannot be mapped: ") + std::strerror(why));
  }
  // If the child is gone already, its ending tells.
  (void)!write(go_end.get(), "", 1);
  return pid;
}

bool become_inner_user() {
  return setresgid(inner_user, inner_user, inner_user) == 0 &&
         setresuid(inner_user, inner_user, inner_user) == 0 &&
         prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

bool become_other_user() {
  if (geteuid() == 0) {
    const uid_t user = outer_user(getpid());
    const bool is_other = setgroups(0, nullptr) == 0 && setresgid(user, user, user) == 0 &&
                          setresuid(user, user, user) == 0;
    // Root of a container that has no other users: at least it loses root's privileges with exec.
    if (!is_other &&
        prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED | SECBIT_NO_SETUID_FIXUP |
                                     SECBIT_NO_SETUID_FIXUP_LOCKED) != 0) {
      return false;
    }
  }
  return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

}  // namespace mirocup::plugins
