// SPDX-License-Identifier: MIT
//
// The common parts of all programs' command lines: `help COMMAND` and one form of errors.
#pragma once

#include "system/command_help.hpp"

#include <optional>
#include <span>
#include <string>

namespace CLI {
class App;
}

namespace mirocup::system {

// Parses the arguments from argv[1] on. The app's name is the way to call it, such as "mirocup
// league". If a subcommand was chosen, its callback has run, and the function returns nothing. If
// help was asked for or the arguments are wrong, prints the help, or the mistake and a command to
// type, and returns the exit code: 0 or 2. `helps` has the examples.
std::optional<int> parse_command_line(CLI::App& app, std::span<const CommandHelp> helps, int argc,
                                      char** argv);

// Answers a command line about the program itself, for a shell or a packager: `complete WORD…`
// prints completions(), `man DIR` writes the manual's pages. Returns nothing for all other command
// lines.
std::optional<int> tell_about(const CLI::App& app, int argc, char** argv,
                              const std::string& version, std::span<const std::string> teams);

// Returns why a text is not a seed, an integer from 0 to 2^64 - 1; "" if the text is a seed.
std::string problem_with_seed(const std::string& text);

}  // namespace mirocup::system
