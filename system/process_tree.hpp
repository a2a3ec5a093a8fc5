// SPDX-License-Identifier: MIT
//
// What a program uses, with all programs that it has started.
#pragma once

#include <map>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

struct TreeUse {
  double seconds = 0.0;      // of processor time
  bool is_runnable = false;  // one of the processes runs, or waits for a processor or a disk
};

// Returns the use of each of these processes, with that of their children, of the children's
// children, and of all of these that have ended and were waited for. A process that is not there
// has 0. A child that was killed together with its parent is no longer counted: a caller who looks
// several times keeps the largest time.
std::map<pid_t, TreeUse> use_of_trees(const std::vector<pid_t>& roots);

}  // namespace mirocup::system
