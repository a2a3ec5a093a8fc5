// SPDX-License-Identifier: MIT
#include "system/command_line.hpp"

#include "core/base/error.hpp"
#include "system/files.hpp"
#include "system/number_of.hpp"
#include "system/printable.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <vector>

namespace mirocup::system {

namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

// Prints what is wrong, and where to read on.
int complain(const std::string& program, const std::string& what) {
  std::cerr << program << ": " << printable(what) << '\n' << "See " << program << " --help\n";
  return exit_code(Errc::input);
}

// The first example of the command's help.
std::string for_example(std::span<const CommandHelp> helps, const std::string& command) {
  for (const CommandHelp& help : helps) {
    if (help.name == command && !help.examples.empty())
      return std::string("; for example: ") + help.examples.front();
  }
  return "";
}

// Returns the library's sentence about a mistake, or our own about a mistake that the state of the
// command shows.
std::string sentence_of(const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<std::string> left = command.remaining();
  const auto unknown = std::find_if(left.begin(), left.end(), [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  });
  if (unknown != left.end()) {
    const std::string name = unknown->substr(0, unknown->find('='));
    return "there is no option " + name;
  }
  const int kind = error.get_exit_code();
  if (kind == static_cast<int>(CLI::ExitCodes::ExtrasError) && !left.empty())
    return in_quotes(left.front()) + " is not expected";
  const auto options = command.get_options();
  const auto doubled = std::find_if(options.begin(), options.end(), [](const CLI::Option* option) {
    return option->get_items_expected_max() == 1 && option->count() > 1;
  });
  if (kind == static_cast<int>(CLI::ExitCodes::ArgumentMismatch) && doubled != options.end())
    return (*doubled)->get_name() + " is given more than once";
  return error.what();
}

int explain(const CLI::App& app, std::span<const CommandHelp> helps, const CLI::ParseError& error) {
  const auto parsed = app.get_subcommands();
  const CLI::App& command = parsed.empty() ? app : *parsed.front();
  const std::string program = app.get_name() + (parsed.empty() ? "" : " " + command.get_name());
  const bool is_wrong_value =
      error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ValidationError);
  return complain(program, sentence_of(command, error) +
                               (is_wrong_value ? "" : for_example(helps, command.get_name())));
}

}  // namespace

std::optional<int> parse_command_line(CLI::App& app, std::span<const CommandHelp> helps, int argc,
                                      char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    words.emplace_back("--help");
  }
  const std::vector<std::string> commands = commands_of(app);
  if (words.empty()) {
    std::cerr << app.help();
    return exit_code(Errc::input);
  }
  const std::string& first = words[0];
  const bool is_known = std::find(commands.begin(), commands.end(), first) != commands.end();
  if (first.empty() || (first.front() != '-' && !is_known)) {
    return complain(app.get_name(), "there is no command " + in_quotes(first));
  }
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return explain(app, helps, error);
    app.exit(error);  // prints the help, or the version
    return exit_yes;
  }
  return std::nullopt;
}

std::optional<int> tell_about(const CLI::App& app, int argc, char** argv,
                              const std::string& version, std::span<const std::string> teams) {
  const std::string first = argc > 1 ? argv[1] : "";
  if (first == "complete") {
    const std::vector<std::string> words(argv + 2, argv + argc);
    std::cout << completions(app, words, teams);
    return exit_yes;
  }
  if (first != "man" || argc != 3) return std::nullopt;
  Disk disk;
  for (const auto& [name, text] : manual_pages(app, version)) {
    const auto written = disk.write(argv[2] + ("/" + name), text);
    if (written) continue;
    std::cerr << app.get_name() << ": " << printable(written.error().what) << '\n';
    return exit_code(written.error().code);
  }
  return exit_yes;
}

std::string problem_with_seed(const std::string& text) {
  if (number_of<std::uint64_t>(text)) return "";
  return in_quotes(text) + " is not a seed, an integer from 0 to 18446744073709551615";
}

}  // namespace mirocup::system
