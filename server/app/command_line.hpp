// SPDX-License-Identifier: MIT
//
// What the command line of `mirocup` asks for. Only command_line.cpp knows the library that reads it.
#pragma once

#include "core/base/error.hpp"

#include <functional>
#include <optional>

namespace mirocup::app {

using Run = std::function<Result<int>()>;

// Sets `run` to the subcommand with its options. Otherwise there is nothing to run, and the answer is
// an exit code: it asked for help, or was wrong; both are told.
std::optional<int> read_command_line(int argc, char** argv, Run& run);

}  // namespace mirocup::app
