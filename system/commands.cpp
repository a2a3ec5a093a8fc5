// SPDX-License-Identifier: MIT
#include "system/commands.hpp"

#include "system/command_line.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
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
  return {problem, has_end
                       ? "NUMBER in [" + number_text(low) + " - " + number_text(high) + "]" + words
                       : ""};
}

}  // namespace

Option Option::named(const std::string& value) const {
  option_->type_name(value);
  return *this;
}

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::shows_default() const {
  option_->capture_default_str();
  return *this;
}

Option Option::between(int low, int high) const {
  option_->check(range(low, high));
  return *this;
}

Option Option::between(double low, double high) const {
  option_->check(range(low, high));
  return *this;
}

Option Option::between_or(int low, int high, const std::string& word) const {
  option_->check(range(low, high, word));
  return *this;
}

Option Option::one_of(const std::vector<std::string>& words) const {
  const auto problem = [words](const std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return "";
    std::string list = joined(words, ", ");
    if (const std::size_t last = list.rfind(", "); last != std::string::npos)
      list.replace(last, 2, " or ");
    return text + " is not " + list;
  };
  option_->check(CLI::Validator(problem, "{" + joined(words, ",") + "}"));
  return *this;
}

Option Option::checked(const std::string& value, std::string (*problem)(const std::string&)) const {
  option_->check(CLI::Validator([problem](std::string& text) { return problem(text); }, value));
  return *this;
}

Option Option::is_a_seed() const {
  return checked("SEED", problem_with_seed);
}

Option Option::split_at(char separator) const {
  option_->delimiter(separator);
  return *this;
}

Option Option::takes(int least, int most) const {
  option_->expected(least, most);
  return *this;
}

Option Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::needs(const Option& other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::in_group(const std::string& heading) const {
  option_->group(heading);
  return *this;
}

Option Option::hidden() const {
  return in_group("");
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
    return Option(app_->add_option(names, read, help, false, default_text)->type_name("FLOAT"));
  } else {
    return Option(app_->add_option(names, value, help));
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
  return Option(app_->add_option_function<std::string>(names, assign, help)).takes(0, 1);
}

Option Command::flag(const std::string& names, bool& value, const std::string& help) const {
  return Option(app_->add_flag(names, value, help));
}

Option Command::jobs(int& value, const std::string& what) const {
  return option("--jobs", value, "Number of " + what + " at once (default: one for each processor)")
      .between(1, 1024);
}

Commands::Commands(const std::string& name, const std::string& description,
                   const std::string& version, const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, name)), version_(version) {
  app_->require_subcommand(1);
  app_->set_version_flag("-v,--version", version);
  app_->footer(footer);
}

Commands::~Commands() = default;

Command Commands::add_run(const CommandHelp& help, Run run) {
  CLI::App* command = app_->add_subcommand(help.name, help.description);
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  helps_.push_back(help);
  return Command(command);
}

void Commands::add_other(const CommandHelp& help) {
  app_->add_subcommand(help.name, help.description);
  helps_.push_back(help);
}

std::variant<Run, int> Commands::read(int argc, char** argv, const ValueNames& values,
                                      std::span<const std::string> teams) {
  finish_help(*app_, helps_, values);
  if (const auto told = tell_about(*app_, argc, argv, version_, teams)) return *told;
  if (const auto done = parse_command_line(*app_, helps_, argc, argv)) return *done;
  return chosen_;
}

}  // namespace mirocup::system
