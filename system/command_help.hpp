// SPDX-License-Identifier: MIT
//
// The help, the shell completion and the manual pages of a program, all made from the declarations
// of its options.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mirocup::system {

// The parts of a command's help besides its options.
struct CommandHelp {
  const char* name;         // name of the subcommand
  const char* group;        // heading of its group in the program's help; "": the help omits it
  const char* description;  // description in the program's help
  std::vector<const char*> examples;
};

// Begins the description of a check, which CLI11 appends to the name of the option's value.
inline constexpr const char* check_mark = "\t";

// Returns the command of that name; null if there is none.
const CLI::App* command_named(const CLI::App& app, const std::string& name);

// Sets the layout of the program's help, and the commands' groups and examples. To be called once,
// after all commands are declared.
void finish_help(CLI::App& app, std::span<const CommandHelp> commands);

// Returns the completions of the last word, a completion in a line: "WORD<tab>DESCRIPTION". `words`
// are the words after the program's name; the last may be "". A last line ":files" means that the
// word may also be a file. `teams` are the names of the house teams.
std::string completions(const CLI::App& app, std::span<const std::string> words,
                        std::span<const std::string> teams);

// Returns the pages of the manual, by the names of their files: mirocup.1, mirocup-match.1.
std::map<std::string, std::string> manual_pages(const CLI::App& app, const std::string& version);

}  // namespace mirocup::system
