// SPDX-License-Identifier: MIT
//
// The beginning of a program, which checks that the system has the parts that it needs, and its
// end: a full disk must not look like success.
#pragma once

#include "core/base/error.hpp"

namespace mirocup::system {

// Call this function first in main(). Errc::unavailable if /proc is missing, because programs use
// /proc to find their parts and to watch their teams. From now on, in this program and in programs
// that it starts, a write beyond the limit on the size of files (RLIMIT_FSIZE) returns an error
// instead of ending the process.
Result<void> begin();

// Flushes standard output. Returns `code`. If `code` is 0 and the output could not be written,
// prints a sentence on standard error and returns 3. A reader that has gone (`| head`) and a closed
// output are not errors.
int after_standard_output(int code);

}  // namespace mirocup::system
