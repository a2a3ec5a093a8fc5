// SPDX-License-Identifier: MIT
#include "programs/coach/process_copy.hpp"

#include <cerrno>
#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace mirocup::coach {

pid_t fork_copy() {
  const pid_t original = getpid();
  const pid_t pid = fork();
  // The original may have died before the kernel knew that its copy has to die with it.
  if (pid == 0 && (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != original)) _exit(1);
  return pid;
}

bool ends_well(pid_t copy) {
  int status = -1;
  while (copy > 0 && waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  return status == 0;
}

}  // namespace mirocup::coach
