// SPDX-License-Identifier: MIT
#include "system/command_line.hpp"

#include "core/base/error.hpp"
#include "system/command_help.hpp"
#include "system/files.hpp"
#include "system/number_of.hpp"
#include "system/printable.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <numeric>
#include <vector>

namespace mirocup::system {

namespace {

constexpr std::size_t max_slips = 2;

// The number of letters that were changed, left out, added, or exchanged with their neighbour
// (optimal string alignment distance).
std::size_t slips_between(std::string_view one, std::string_view other) {
  std::vector<std::vector<std::size_t>> d(one.size() + 1,
                                          std::vector<std::size_t>(other.size() + 1));
  for (std::size_t i = 0; i <= one.size(); ++i) d[i][0] = i;
  std::iota(d[0].begin(), d[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= one.size(); ++i) {
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const std::size_t changed = d[i - 1][j - 1] + (one[i - 1] == other[j - 1] ? 0 : 1);
      d[i][j] = std::min({changed, d[i - 1][j] + 1, d[i][j - 1] + 1});
      const bool is_exchanged =
          i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1];
      if (is_exchanged) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[one.size()][other.size()];
}

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

// The options of the command as they are typed, "--seed".
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string or_meant(const std::string& meant) {
  return meant.empty() ? "" : "; did you mean " + meant + "?";
}

// Prints what is wrong, and where to read on.
int complain(const std::string& program, const std::string& what) {
  std::cerr << program << ": " << printable(what) << '\n' << "See " << program << " --help\n";
  return exit_code(Errc::input);
}

// The subcommand that was being parsed, and how it is called.
std::pair<const CLI::App*, std::string> parsed_command(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  if (parsed.empty()) return {&app, app.get_name()};
  return {parsed.front(), app.get_name() + " " + parsed.front()->get_name()};
}

// The first example of the command's help.
std::string example_of(const CLI::App& command) {
  const std::string footer = command.get_footer();
  const std::size_t begin = footer.find("\n  ");
  if (begin == std::string::npos) return "";
  return footer.substr(begin + 3, footer.find('\n', begin + 1) - begin - 3);
}

std::string for_example(const CLI::App& command) {
  const std::string example = example_of(command);
  return example.empty() ? "" : "; for example: " + example;
}

// Returns a sentence that says what to type.
std::string sentence_of(const CLI::App& command, const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::string kind = error.get_name();
  const std::string option = text.substr(0, text.find(kind == "RequiredError" ? " " : ":"));
  const CLI::Option* known = command.get_option_no_throw(option);
  if (kind == "RequiredError") return option + " is missing" + for_example(command);
  // Its name is the command's.
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
    return in_quotes(text.substr(text.rfind(": ") + 2)) + " is not expected" + for_example(command);
  if (kind == "ArgumentMismatch" && text.find(": At Most ") != std::string::npos)
    return option + " is given more than once" + for_example(command);
  if (kind == "ArgumentMismatch" && known != nullptr) {
    const std::string name =
        known->get_positional() ? "" : " " + own_value_name(known->get_type_name());
    return option + " needs " + (known->get_items_expected_min() > 1 ? "more values" : "a value") +
           (name.size() > 1 ? ": " + option + name : "") + for_example(command);
  }
  if (kind == "ConversionError") {
    const std::string pair = text.substr(std::min(text.find(": ") + 2, text.size()));
    const std::string name = pair.substr(0, pair.find(" = "));
    const CLI::Option* flag = command.get_option_no_throw(name);
    if (flag != nullptr && flag->get_items_expected_max() == 0) return name + " takes no value";
    return name + " " + pair.substr(std::min(pair.find(" = ") + 3, pair.size())) +
           ": a number is expected";
  }
  if (kind == "ExcludesError") {
    const std::size_t middle = text.find(" excludes ");
    return text.substr(0, middle) + " and " + text.substr(middle + 10) +
           " do not go together: leave one of them out";
  }
  if (kind == "RequiresError") {
    const std::size_t middle = text.find(" requires ");
    return text.substr(0, middle) + " works only together with " + text.substr(middle + 10);
  }
  if (kind == "ValidationError") return option + text.substr(option.size() + 2);
  return text;
}

int explain(const CLI::App& app, const CLI::ParseError& error) {
  const auto [command, program] = parsed_command(app);
  const std::vector<std::string> left = command->remaining();
  const auto unknown = std::find_if(left.begin(), left.end(), [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  });
  if (unknown == left.end()) return complain(program, sentence_of(*command, error));
  const std::string name = unknown->substr(0, unknown->find('='));
  return complain(
      program, "there is no option " + name + or_meant(closest_word(name, options_of(*command))));
}

}  // namespace

std::string closest_word(std::string_view word, std::span<const std::string> words) {
  std::string best;
  std::size_t fewest = std::min(max_slips, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const std::size_t slips = slips_between(word, candidate);
    if (slips >= fewest) continue;
    fewest = slips;
    best = candidate;
  }
  return best;
}

std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv) {
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
    std::vector<std::string> meant = commands;
    meant.insert(meant.end(), {"help", "version"});
    std::string closest = closest_word(first, meant);
    if (closest == "version") closest = "--version";
    return complain(app.get_name(), "there is no command " + in_quotes(first) + or_meant(closest));
  }
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return explain(app, error);
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
