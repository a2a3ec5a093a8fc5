// SPDX-License-Identifier: MIT
//
// Catches a measure that sees the program that was started, and not what that one starts.
#include "system/process_tree.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <ctime>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup::system {
namespace {

double own_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void use_processor(double seconds) {
  while (own_seconds() < seconds) {
  }
}

TEST(ProcessTree, CountsWhatItsProgramsUse) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t root = fork();
  if (root == 0) {
    const pid_t ended = fork();
    if (ended == 0) {
      use_processor(0.1);
      _exit(0);
    }
    waitpid(ended, nullptr, 0);
    const pid_t below = fork();
    if (below == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      prctl(PR_SET_NAME, "a) R 1\nb");  // a name that hides nothing
      use_processor(0.1);
      (void)!write(ends[1], "x", 1);
      pause();
    }
    pause();
  }
  char ready = 0;
  ASSERT_EQ(read(ends[0], &ready, 1), 1);
  const auto used = use_of_trees({root, 999'999'999});
  EXPECT_GE(used.at(root).seconds, 0.18) << "0.1 s that is over, and 0.1 s of a process that lives";
  EXPECT_EQ(used.at(999'999'999).seconds, 0.0);
  EXPECT_TRUE(use_of_trees({getpid()}).at(getpid()).is_runnable) << "this process runs";
  const auto parents = use_of_trees({getpid()});
  EXPECT_GE(parents.at(getpid()).seconds, 0.18) << "the whole tree";
  kill(root, SIGKILL);
  waitpid(root, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace mirocup::system
