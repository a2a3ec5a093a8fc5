// SPDX-License-Identifier: MIT
//
// The command line of `mirocup league`: the list of its subcommands.
#pragma once

#include "system/commands.hpp"

#include <variant>

namespace mirocup::league {

// Returns the subcommand with its options. If the command line asks for help or is wrong, prints
// the help or the error and returns the exit code instead.
std::variant<system::Run, int> read_command_line(int argc, char** argv);

}  // namespace mirocup::league
