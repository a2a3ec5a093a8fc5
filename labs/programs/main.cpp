// SPDX-License-Identifier: MIT
//
// mirocup-labs: what serves research. `mirocup NAME` starts this program for each of its commands.
#include "labs/programs/commands.hpp"
#include "record/match_record.hpp"
#include "system/begin.hpp"
#include "system/child_process.hpp"
#include "system/commands.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <variant>

namespace mirocup::labs {

namespace {

// The names of values that the help prints for options which declare no such name.
const system::ValueNames value_names{
    {"--noise-mm", "MM"},        {"--noise-deg", "DEGREES"},  {"--gaps", "SHARE"},
    {"--outliers", "SHARE"},     {"--seed", "SEED"},          {"--half", "SECONDS"},
    {"--jobs", "NUMBER"},        {"--param", "KEY=LOW:HIGH"}, {"--against", "TEAM,TEAM"},
    {"--generations", "NUMBER"}, {"--fixtures", "NUMBER"},    {"--test", "NUMBER"},
    {"--output", "DIR"},
};

}  // namespace

Error become_bench(std::vector<std::string> arguments) {
  return system::become_sibling_program("mirocup-bench", std::move(arguments),
                                        "-D MIROCUP_LABS=ON -D MIROCUP_TESTS=ON");
}

// Returns the subcommand with its options. If the command line asks for help or is wrong, prints
// the help or the error and returns the exit code instead. The program's name is that of the one
// which people call.
static std::variant<system::Run, int> read_command_line(int argc, char** argv) {
  system::Commands commands("mirocup", "The commands of mirocup that serve research.",
                            record::software_version(),
                            "mirocup help COMMAND explains a command, with examples.");
  for (Add* const add :
       {add_export, add_tune, add_record_as_seen, add_identify, add_validate, add_new})
    add(commands);
  commands.add_other({"bench",
                      for_engineers,
                      "Compare speed and error with other engines: mirocup bench --help",
                      {"mirocup bench --quick"}});
  return commands.read(argc, argv, value_names, system::house_teams());
}

}  // namespace mirocup::labs

using namespace mirocup;

namespace {

Result<int> run(int argc, char** argv) {
  MIROCUP_TRY_VOID(system::begin());
  if (argc > 1 && argv[1] == std::string("bench"))
    return tl::unexpected(labs::become_bench({argv + 2, argv + argc}));
  const auto chosen = labs::read_command_line(argc, argv);
  if (const int* done = std::get_if<int>(&chosen)) return *done;
  return std::get<system::Run>(chosen)();
}

}  // namespace

int main(int argc, char** argv) {
  const Result<int> result = run(argc, argv);
  if (result) return system::after_standard_output(*result);
  std::cerr << "mirocup: " << system::printable(result.error().what) << '\n';
  return exit_code(result.error().code);
}
