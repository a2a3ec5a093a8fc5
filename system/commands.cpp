// SPDX-License-Identifier: MIT
#include "system/commands.hpp"

#include "system/files.hpp"
#include "system/number_of.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <limits>

namespace mirocup::system {

namespace {

template <class Number>
std::string number_text(Number number) {
  return system::formatted("%.10g", static_cast<double>(number));
}

template <class Number>
CLI::Validator range(Number low, Number high, const std::string& word = "") {
  const bool has_end = high < std::numeric_limits<Number>::max();
  const std::string expected = (has_end ? "from " + number_text(low) + " to " + number_text(high)
                                        : "of at least " + number_text(low)) +
                               (word.empty() ? "" : " or " + word);
  const auto problem = [=](const std::string& text) {
    const auto number = number_of<Number>(text);
    const bool is_good = number ? *number >= low && *number <= high : !word.empty() && text == word;
    return is_good ? "" : text + " is not a number " + expected;
  };
  const std::string words = word.empty() ? "" : " OR {" + word + "}";
  return {problem,
          has_end ? check_mark + ("[" + number_text(low) + " to " + number_text(high) + "]") + words
                  : ""};
}

}  // namespace

std::string problem_with_seed(const std::string& text) {
  if (number_of<std::uint64_t>(text)) return "";
  return in_quotes(text) + " is not a seed, an integer from 0 to 18446744073709551615";
}

Option Option::required() const {
  return Option(option_->required());
}

Option Option::shows_default() const {
  return Option(option_->capture_default_str());
}

Option Option::between(int low, int high) const {
  return Option(option_->check(range(low, high)));
}

Option Option::between(double low, double high) const {
  return Option(option_->check(range(low, high)));
}

Option Option::between_or(int low, int high, const std::string& word) const {
  return Option(option_->check(range(low, high, word)));
}

Option Option::one_of(const std::vector<std::string>& words) const {
  const auto problem = [words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return "";
    std::string list = joined(words, ", ");
    if (const std::size_t last = list.rfind(", "); last != std::string::npos)
      list.replace(last, 2, " or ");
    return text + " is not " + list;
  };
  return Option(
      option_->check(CLI::Validator(problem, check_mark + ("{" + joined(words, ",") + "}"))));
}

Option Option::checked(const std::string& value, std::string (*problem)(const std::string&)) const {
  return Option(option_->check(
      CLI::Validator([problem](std::string& text) { return problem(text); }, check_mark + value)));
}

Option Option::is_a_seed() const {
  return checked("SEED", problem_with_seed);
}

Option Option::split_at(char separator) const {
  return Option(option_->delimiter(separator));
}

Option Option::takes(int least, int most) const {
  return Option(option_->expected(least, most));
}

Option Option::excludes(const Option& other) const {
  return Option(option_->excludes(other.option_));
}

Option Option::needs(const Option& other) const {
  return Option(option_->needs(other.option_));
}

Option Option::in_group(const std::string& heading) const {
  return Option(option_->group(heading));
}

Option Option::hidden() const {
  return in_group("");
}

// "--output FILE": the names of an option, and that of its value.
static CLI::Option* with_value_name(CLI::Option* option, const std::string& names) {
  const std::size_t blank = names.find(' ');
  return option->type_name(blank == std::string::npos ? "VALUE" : names.substr(blank + 1));
}

static std::string without_value_name(const std::string& names) {
  return names.substr(0, names.find(' '));
}

template <class T>
Option Command::option(const std::string& names, T& value, const std::string& help) const {
  using Number = typename decltype(std::optional(value))::value_type;
  if constexpr (std::is_arithmetic_v<Number>) {
    // The library's own conversion takes "nan", "0x1p3", " 5", "true", and "010" for 8.
    const auto read = [&value](const CLI::results_t& words) {
      const auto number = number_of<Number>(words.front());
      if (number) value = *number;
      return number.has_value();
    };
    const auto default_text = [&value] { return number_text(std::optional(value).value_or(0)); };
    CLI::Option* const option =
        app_->add_option(without_value_name(names), read, help, false, default_text);
    return Option(with_value_name(option, names));
  } else {
    return Option(with_value_name(app_->add_option(without_value_name(names), value, help), names));
  }
}

template Option Command::option(const std::string&, std::string&, const std::string&) const;
template Option Command::option(const std::string&, int&, const std::string&) const;
template Option Command::option(const std::string&, std::int64_t&, const std::string&) const;
template Option Command::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Command::option(const std::string&, double&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<std::string>&,
                                const std::string&) const;
template Option Command::option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<std::uint32_t>&,
                                const std::string&) const;
template Option Command::option(const std::string&, std::optional<double>&,
                                const std::string&) const;
template Option Command::option(const std::string&, std::vector<std::string>&,
                                const std::string&) const;

Option Command::option_or_flag(const std::string& names, std::optional<std::string>& value,
                               const std::string& help) const {
  const auto assign = [&value](const std::string& text) { value = text; };
  CLI::Option* const option =
      app_->add_option_function<std::string>(without_value_name(names), assign, help);
  return Option(with_value_name(option, names)).takes(0, 1);
}

Option Command::flag(const std::string& names, bool& value, const std::string& help) const {
  return Option(app_->add_flag(names, value, help));
}

Option Command::jobs(int& value, const std::string& what) const {
  return option("--jobs NUMBER", value,
                "Number of " + what + " at once (default: one for each processor)")
      .between(1, 1024);
}

namespace {

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
  return replaced(error.what(), check_mark, "");
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

// Parses the arguments from argv[1] on. The app's name is the way to call it, such as "mirocup
// league". If a subcommand was chosen, its callback has run, and the function returns nothing. If
// help was asked for or the arguments are wrong, prints the help, or the mistake and a command to
// type, and returns the exit code: 0 or 2. `helps` has the examples.
std::optional<int> parse_command_line(CLI::App& app, std::span<const CommandHelp> helps, int argc,
                                      char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    words.resize(std::min<std::size_t>(words.size(), 1));
    words.emplace_back("--help");
  }
  if (words.empty()) {
    std::cerr << app.help();
    return exit_code(Errc::input);
  }
  const std::string& first = words[0];
  if (first.empty() || (first.front() != '-' && command_named(app, first) == nullptr)) {
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

// Answers a command line about the program itself, for a shell or a packager: `complete WORD…`
// prints completions(), `man DIR` writes the manual's pages. Returns nothing for all other command
// lines.
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

}  // namespace

Commands::Commands(const std::string& name, const std::string& description,
                   const std::string& version, const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, name)), version_(version) {
  app_->require_subcommand(1);
  app_->set_version_flag("-v,--version", version);
  app_->footer(footer);
}

Commands::~Commands() = default;

Command Commands::add_run(const CommandHelp& help, std::function<Result<int>()> run) {
  CLI::App* command = app_->add_subcommand(help.name, help.description);
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  helps_.push_back(help);
  return Command(command);
}

void Commands::add_other(const CommandHelp& help) {
  app_->add_subcommand(help.name, help.description);
  helps_.push_back(help);
}

Result<int> Commands::run(int argc, char** argv, std::span<const std::string> teams) {
  finish_help(*app_, helps_);
  if (const auto told = tell_about(*app_, argc, argv, version_, teams)) return *told;
  if (const auto done = parse_command_line(*app_, helps_, argc, argv)) return *done;
  return chosen_();
}

}  // namespace mirocup::system
