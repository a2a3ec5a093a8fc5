// SPDX-License-Identifier: MIT
#include "system/begin.hpp"

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace mirocup::system {

namespace {

bool is_output_wanted() {
  if (fcntl(STDOUT_FILENO, F_GETFD) < 0) return false;
  pollfd output{.fd = STDOUT_FILENO, .events = 0, .revents = 0};
  return poll(&output, 1, 0) != 1 || (output.revents & POLLERR) == 0;
}

}  // namespace

Result<void> begin() {
  std::signal(SIGXFSZ, SIG_IGN);
  if (access("/proc/self/exe", F_OK) == 0) return {};
  return fail(Errc::unavailable, "/proc is not mounted here: mirocup cannot run without it");
}

int after_standard_output(int code) {
  std::cout.flush();
  const bool is_written = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written || code != 0 || !is_output_wanted()) return code;
  std::cerr << "mirocup: standard output could not be written as a whole\n";
  return exit_code(Errc::unavailable);
}

}  // namespace mirocup::system
