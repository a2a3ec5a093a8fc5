// SPDX-License-Identifier: MIT
#include "system/begin.hpp"

#include <csignal>
#include <unistd.h>

namespace mirocup::system {

Result<void> begin() {
  std::signal(SIGXFSZ, SIG_IGN);
  if (access("/proc/self/exe", F_OK) == 0) return {};
  return fail(Errc::unavailable, "/proc is not mounted here: mirocup cannot run without it");
}

}  // namespace mirocup::system
