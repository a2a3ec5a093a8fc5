// SPDX-License-Identifier: MIT
//
// The begin of a program: what it needs of the system that it runs on.
#pragma once

#include "core/base/error.hpp"

namespace mirocup::system {

// Call it first in main(). Errc::unavailable if /proc is missing, by which programs find their
// parts and watch their teams. A write beyond the limit on the size of files (RLIMIT_FSIZE) returns
// an error from now on, here and in programs that are started, and does not end the process.
Result<void> begin();

}  // namespace mirocup::system
