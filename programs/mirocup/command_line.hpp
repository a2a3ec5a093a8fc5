// SPDX-License-Identifier: MIT
//
// Reads the command line of `mirocup`. Only command_line.cpp knows the library that parses it.
#pragma once

#include "core/base/error.hpp"

#include <functional>
#include <optional>

namespace mirocup::app {

using Run = std::function<Result<int>()>;

// Sets `run` to the subcommand with its options and returns nothing. If the command line asks for
// help or is wrong, prints the help or the error and returns the exit code instead.
std::optional<int> read_command_line(int argc, char** argv, Run& run);

}  // namespace mirocup::app
