// SPDX-License-Identifier: MIT
//
// The command line of `mirocup league`. Only command_line.cpp includes the library that reads it.
#pragma once

#include "core/base/error.hpp"

#include <functional>
#include <optional>

namespace mirocup::league {

using Action = std::function<Result<int>()>;

// Sets `action` to the subcommand with its options, and returns nothing. If the command line asks
// for help or is wrong, prints the help or the mistake and returns the exit code.
std::optional<int> read_command_line(int argc, char** argv, Action& action);

}  // namespace mirocup::league
