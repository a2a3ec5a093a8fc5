// SPDX-License-Identifier: MIT
//
// The beginning of a program: checks that the system has the parts that it needs.
#pragma once

#include "core/base/error.hpp"

namespace mirocup::system {

// Call this function first in main(). Errc::unavailable if /proc is missing, because programs use
// /proc to find their parts and to watch their teams. From now on, in this program and in programs
// that it starts, a write beyond the limit on the size of files (RLIMIT_FSIZE) returns an error
// instead of ending the process.
Result<void> begin();

}  // namespace mirocup::system
