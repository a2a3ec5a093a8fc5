// SPDX-License-Identifier: MIT
//
// What the command lines of all programs have in common: `help COMMAND`, a guess at what was meant
// where a command or an option is misspelt, and one form of errors.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace mirocup::system {

// Returns the one of the words that was probably meant: at most two letters were changed, left out,
// added or exchanged, and not more than a third of the word. "" if there is none.
std::string closest_word(std::string_view word, std::span<const std::string> words);

// Parses the arguments, argv[1] and on, for an app whose name is how it is called, such as "mirocup
// league". Returns nothing if a subcommand was chosen, whose callback has then run. If help was
// asked for or the arguments are wrong, prints the help, or what is wrong and what to type, and
// returns the exit code: 0 or 2.
std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv);

// Answers a command line that asks about the program itself, for a shell or a packager: `complete
// WORD…` prints completions(), `man DIR` writes the manual's pages. Returns nothing for any other.
std::optional<int> tell_about(const CLI::App& app, int argc, char** argv,
                              const std::string& version, std::span<const std::string> teams);

// Returns what is wrong with a text as a seed, an integer from 0 to 2^64 - 1, or "".
std::string problem_with_seed(const std::string& text);

}  // namespace mirocup::system
