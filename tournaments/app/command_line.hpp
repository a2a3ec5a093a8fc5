// SPDX-License-Identifier: MIT
//
// What the command line of `mirocup league` asks for. Only command_line.cpp knows the library that
// reads it.
#pragma once

#include "core/base/error.hpp"

#include <functional>
#include <optional>

namespace mirocup::league {

using Action = std::function<Result<int>()>;

// Sets `action` to the subcommand with its options. Otherwise there is nothing to run, and the
// answer is an exit code: it asked for help, or was wrong; both are told.
std::optional<int> read_command_line(int argc, char** argv, Action& action);

}  // namespace mirocup::league
