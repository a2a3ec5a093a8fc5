// SPDX-License-Identifier: MIT
//
// Reads the command line of `mirocup league`. Only command_line.cpp depends on CLI11.
#pragma once

#include "core/base/error.hpp"

#include <functional>
#include <optional>

namespace mirocup::league {

using Action = std::function<Result<int>()>;

// Sets `action` to the subcommand with its options and returns an empty value. If the arguments ask
// for help or are wrong, prints the help or the error and returns the exit code instead.
std::optional<int> read_command_line(int argc, char** argv, Action& action);

}  // namespace mirocup::league
