// SPDX-License-Identifier: MIT
//
// The subcommands of a program. Each subcommand declares its options in the source that runs it;
// the program lists the subcommands. Only this folder knows the library that parses command lines
// (CLI11).
#pragma once

#include "core/base/error.hpp"
#include "core/base/names.hpp"
#include "system/command_help.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace mirocup::system {

// An option or an argument of a command. A handle, valid as long as its Commands exists.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  Option shows_default() const;

  // Sets the range of accepted values; other values, NaN among them, are wrong usage.
  Option between(int low, int high) const;
  Option between(double low, double high) const;
  Option between_or(int low, int high, const std::string& word) const;
  Option one_of(const std::vector<std::string>& words) const;
  Option is_a_seed() const;  // an integer of 64 bits
  // Sets the value's name in the help and its check: `problem` returns why a text is wrong, or "".
  Option checked(const std::string& value, std::string (*problem)(const std::string&)) const;

  // Makes the option's value a list that the separator divides: "a,b".
  Option split_at(char separator) const;
  // Sets the least and the greatest number of words after the option.
  Option takes(int least, int most) const;

  Option excludes(const Option& other) const;
  Option needs(const Option& other) const;
  Option in_group(const std::string& heading) const;
  Option hidden() const;

 private:
  CLI::Option* option_;
};

// A subcommand whose options are declared. A handle, valid as long as its Commands exists.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  // Adds an option "-o,--output FILE", where FILE is the name of its value in the help (default:
  // VALUE), or an argument "FILE". `value` is its default and gets the typed value. T: std::string,
  // an integer, double, a std::optional of one of these, or a list of std::string. A number is
  // written as number_of() reads it.
  template <class T>
  Option option(const std::string& names, T& value, const std::string& help = "") const;
  // Adds an option whose value may be missing: then `value` becomes "".
  Option option_or_flag(const std::string& names, std::optional<std::string>& value,
                        const std::string& help) const;
  Option flag(const std::string& names, bool& value, const std::string& help) const;
  // Adds the option --jobs, the number of `what` at once; 0, the default: one for each processor.
  Option jobs(int& value, const std::string& what) const;

 private:
  CLI::App* app_;
};

// The subcommands of one program.
class Commands {
 public:
  // `name` is the way to call the program: "mirocup league". `footer` ends the program's help.
  Commands(const std::string& name, const std::string& description, const std::string& version,
           const std::string& footer);
  ~Commands();
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  template <class Options>
  struct Added {
    Command command;
    Options& options;
  };

  // Adds a subcommand with its help (CommandHelp). Declare its options next: they fill `options`,
  // which `run` gets.
  template <class Options>
  Added<Options> add(Result<int> (*run)(const Options&), const char* name, const char* group,
                     const char* description, std::vector<const char*> examples) {
    auto options = std::make_shared<Options>();
    return {add_run({name, group, description, std::move(examples)},
                    [options, run] { return run(*options); }),
            *options};
  }

  // Adds the help of a command that another program runs, so that this command never comes to
  // run().
  void add_other(const CommandHelp& help);

  // Runs the subcommand that was chosen, and returns its result. If the command line asks for help
  // or is wrong, prints the help or the error and returns the exit code. `teams` are the names of
  // the house teams, for completion.
  Result<int> run(int argc, char** argv, std::span<const std::string> teams);

 private:
  Command add_run(const CommandHelp& help, std::function<Result<int>()> run);

  std::unique_ptr<CLI::App> app_;
  std::string version_;
  std::vector<CommandHelp> helps_;
  std::function<Result<int>()> chosen_;
};

// Returns why a text is not a seed, an integer from 0 to 2^64 - 1; "" if the text is a seed.
std::string problem_with_seed(const std::string& text);

// The names of an enum, for Option::one_of.
template <class E>
std::vector<std::string> names_of() {
  return {enum_names<E>.begin(), enum_names<E>.end()};
}

}  // namespace mirocup::system
