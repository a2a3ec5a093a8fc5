// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/fork.hpp"

#include "system/descriptor.hpp"

#include <array>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <string>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>

namespace mirocup::plugins {

namespace {

// The user of a team's process inside its own namespace.
constexpr uid_t inner_user = 1000;

// The users outside, if the server is root: they own nothing, and each process gets one of its own,
// so that limits and signals of one team reach no other.
constexpr uid_t first_outer_user = 61000;
constexpr uid_t outer_users = 1000;

uid_t outer_user(pid_t pid) {
  return first_outer_user + static_cast<uid_t>(pid) % outer_users;
}

bool write_to(const std::string& path, const std::string& text) {
  const system::Descriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  return write(file.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

// Maps the one user and group of the child's namespace to a user and a group outside.
bool write_id_maps(pid_t pid) {
  const std::string folder = "/proc/" + std::to_string(pid) + "/";
  if (!write_to(folder + "setgroups", "deny")) return false;
  const auto map_to = [&](uid_t user, gid_t group) {
    const std::string inner = std::to_string(inner_user) + " ";
    return write_to(folder + "gid_map", inner + std::to_string(group) + " 1\n") &&
           write_to(folder + "uid_map", inner + std::to_string(user) + " 1\n");
  };
  // Fails for the root of a container that has no other users.
  if (geteuid() == 0 && map_to(outer_user(pid), outer_user(pid))) return true;
  return map_to(geteuid(), getegid());
}

// In the child. Not the C library's functions: they would signal the parent's other threads, which
// the child does not have, and wait for them for ever.
bool set_user(uid_t user) {
  return syscall(SYS_setresgid, user, user, user) == 0 &&
         syscall(SYS_setresuid, user, user, user) == 0;
}

// In the child of tier T2: becomes the only user of its namespace, and from here on dies with the
// parent.
bool become_inner_user() {
  return set_user(inner_user) && prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

bool drop_privileges() {
  __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
  const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  return syscall(SYS_capset, &header, none.data()) == 0 &&
         prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

// In the child of tier T1: stops being root, and from here on dies with the parent.
bool become_other_user() {
  if (geteuid() == 0) {
    const uid_t user = outer_user(getpid());
    const bool is_other = syscall(SYS_setgroups, 0, nullptr) == 0 && set_user(user);
    // The root of a container that has no other users, or no right to become one, stays root. It
    // drops its privileges, and exec gives none back.
    if (!is_other && !drop_privileges()) return false;
  }
  return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

tl::unexpected<Error> no_sandbox(const char* what) {
  return fail(Errc::unavailable, std::string(what) + ": " + std::strerror(errno));
}

// Parent and child send each other single bytes to keep in step. Both functions return false if the
// other side is gone.
bool send_byte(const system::Descriptor& line) {
  return send(line.get(), "", 1, MSG_NOSIGNAL) == 1;
}
bool receive_byte(const system::Descriptor& line) {
  char byte = 0;
  return TEMP_FAILURE_RETRY(read(line.get(), &byte, 1)) == 1;
}

}  // namespace

// Becoming another user clears the signal that the child gets when its parent dies. So the child
// asks for it again and then goes on only after another byte from its parent, which proves that the
// parent still lives.
Result<pid_t> fork_isolated(Isolation isolation, const std::function<void()>& run) {
  assert(isolation != Isolation::none);
  const bool has_namespaces = isolation == Isolation::T2;
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return no_sandbox("a pair of sockets cannot be made");
  system::Descriptor line(ends[0]);
  system::Descriptor child_line(ends[1]);
  const int namespaces = CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWIPC |
                         CLONE_NEWUTS | CLONE_NEWCGROUP;
  const long flags = SIGCHLD | (has_namespaces ? namespaces : 0);
  const auto pid = static_cast<pid_t>(syscall(SYS_clone, flags, 0, 0, 0, 0));
  if (pid < 0)
    return no_sandbox(has_namespaces ? "a process with namespaces of its own cannot be started"
                                     : "a process cannot be started");
  if (pid == 0) {
    line.reset();
    if (receive_byte(child_line) && (has_namespaces ? become_inner_user() : become_other_user()) &&
        send_byte(child_line) && receive_byte(child_line)) {
      run();
    }
    _exit(127);
  }
  child_line.reset();
  if ((!has_namespaces || write_id_maps(pid)) && send_byte(line) && receive_byte(line) &&
      send_byte(line))
    return pid;
  const auto error = no_sandbox("a team's process cannot get a separate user");
  kill(pid, SIGKILL);
  waitpid(pid, nullptr, 0);
  return error;
}

bool take_descriptors(std::span<const int> descriptors) {
  constexpr int first_spare = 32;  // greater than all numbers that the descriptors get
  std::array<int, first_spare> spare;
  const int count = static_cast<int>(descriptors.size());
  for (int i = 0; i < count; ++i) {
    spare[i] = fcntl(descriptors[i], F_DUPFD, first_spare);
    if (spare[i] < 0) return false;
  }
  for (int i = 0; i < count; ++i) {
    if (dup2(spare[i], i) < 0) return false;
  }
  return close_range(count, ~0U, 0) == 0;
}

void give_up(int to, const char* step) {
  std::array<char, 200> text;
  (void)std::snprintf(text.data(), text.size(), "%s: %s", step, strerrordesc_np(errno));
  (void)!write(to, text.data(), std::strlen(text.data()));
  _exit(127);
}

}  // namespace mirocup::plugins
