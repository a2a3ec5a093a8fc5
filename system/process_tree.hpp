// SPDX-License-Identifier: MIT
//
// The processor time of a program and of all programs that it has started.
#pragma once

#include <map>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

struct TreeUse {
  double seconds = 0.0;      // processor time, s
  bool is_runnable = false;  // one of the processes runs, or waits for a processor or a disk
};

// Returns the values of each of `roots` with all its descendants, also descendants that have ended
// and were waited for. A process that does not exist has 0 s. A child that was killed together with
// its parent no longer counts, so a caller that asks repeatedly keeps the largest time.
std::map<pid_t, TreeUse> use_of_trees(const std::vector<pid_t>& roots);

}  // namespace mirocup::system
