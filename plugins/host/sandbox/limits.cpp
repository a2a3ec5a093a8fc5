// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/limits.hpp"

#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace mirocup::plugins {

namespace {

struct Limit {
  __rlimit_resource_t resource;
  rlim_t value;
};

// There is none of processor time: with RLIMIT_CPU the kernel lets the clock of the process's time
// step in 4 ms, and a long leg may take hours. The server's budgets end a team, and the death of
// the server does.
constexpr Limit limits[] = {
    {RLIMIT_AS, max_memory}, {RLIMIT_STACK, 8u << 20}, {RLIMIT_FSIZE, 0},   {RLIMIT_NOFILE, 16},
    {RLIMIT_NPROC, 1},       {RLIMIT_CORE, 0},         {RLIMIT_MEMLOCK, 0}, {RLIMIT_MSGQUEUE, 0},
    {RLIMIT_SIGPENDING, 16}, {RLIMIT_LOCKS, 0},
};

// Where the host has a limit of processor time, only its hard one is left, which ends the process
// by SIGKILL: a failure of the host. The soft one would look like a crash of the team.
bool leave_only_the_hosts_limit_of_time() {
  rlimit time{};
  if (getrlimit(RLIMIT_CPU, &time) != 0) return false;
  time.rlim_cur = time.rlim_max;
  return setrlimit(RLIMIT_CPU, &time) == 0;
}

}  // namespace

bool limit_this_process() {
  for (const Limit& limit : limits) {
    const rlimit both{limit.value, limit.value};
    if (setrlimit(limit.resource, &both) != 0) return false;
  }
  if (!leave_only_the_hosts_limit_of_time()) return false;
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_DUMPABLE, 0) == 0 &&
         prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

}  // namespace mirocup::plugins
