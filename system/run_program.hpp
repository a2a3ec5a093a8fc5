// SPDX-License-Identifier: MIT
//
// What the main() of a program calls.
#pragma once

#include "core/base/error.hpp"

#include <functional>

namespace mirocup::system {

// Returns the exit code of a program that does `run`, after it has printed the error, if there is
// one. Without /proc, with which programs find their parts and watch their teams, it prints so and
// runs nothing. From now on, in this program and in programs that it starts, a write beyond the
// limit on the size of files (RLIMIT_FSIZE) returns an error instead of ending the process.
//
// A full disk must not look like success: if standard output could not be written, prints a
// sentence on standard error and returns 3. A reader that has gone (`| head`) and a closed output
// are not errors.
int run_program(const std::function<Result<int>()>& run);

}  // namespace mirocup::system
