// SPDX-License-Identifier: MIT
#include "system/run_program.hpp"

#include "system/printable.hpp"

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

int after_standard_output(int code) {
  std::cout.flush();
  const bool is_written = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written || code != 0 || !is_output_wanted()) return code;
  std::cerr << "mirocup: standard output could not be written as a whole\n";
  return exit_code(Errc::unavailable);
}

}  // namespace

int run_program(const std::function<Result<int>()>& run) {
  std::signal(SIGXFSZ, SIG_IGN);
  const bool has_proc = access("/proc/self/exe", F_OK) == 0;
  const Result<int> done =
      has_proc
          ? run()
          : fail(Errc::unavailable, "/proc is not mounted here: mirocup cannot run without it");
  if (!done) std::cerr << "mirocup: " << printable(done.error().what) << '\n';
  return after_standard_output(done ? *done : exit_code(done.error().code));
}

}  // namespace mirocup::system
