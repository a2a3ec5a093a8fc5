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

// The server's budgets end a team long before RLIMIT_CPU, which is for a server that cannot.
constexpr Limit limits[] = {
    {RLIMIT_AS, max_memory}, {RLIMIT_STACK, 8u << 20}, {RLIMIT_CPU, 3600}, {RLIMIT_FSIZE, 0},
    {RLIMIT_NOFILE, 16},     {RLIMIT_NPROC, 1},        {RLIMIT_CORE, 0},   {RLIMIT_MEMLOCK, 0},
    {RLIMIT_MSGQUEUE, 0},    {RLIMIT_SIGPENDING, 16},  {RLIMIT_LOCKS, 0},
};

}  // namespace

bool limit_this_process() {
  for (const Limit& limit : limits) {
    const rlimit both{limit.value, limit.value};
    if (setrlimit(limit.resource, &both) != 0) return false;
  }
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_DUMPABLE, 0) == 0 &&
         prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

}  // namespace mirocup::plugins
