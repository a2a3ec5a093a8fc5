// SPDX-License-Identifier: MIT
//
// The processor time of a program with all programs that it has started.
#pragma once

#include <map>
#include <sys/types.h>
#include <vector>

namespace mirocup::system {

// Returns the processor time of each of these processes, s, with that of their children, of the
// children's children, and of all of these that have ended and were waited for. A process that is
// not there has 0. A child that was killed together with its parent is no longer counted: a caller
// who looks several times keeps the largest value.
std::map<pid_t, double> processor_seconds_of_trees(const std::vector<pid_t>& roots);

}  // namespace mirocup::system
