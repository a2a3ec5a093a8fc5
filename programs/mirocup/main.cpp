// SPDX-License-Identifier: MIT
//
// mirocup: one match, its records, its teams. One file per subcommand.
#include "programs/mirocup/commands.hpp"
#include "record/match_record.hpp"
#include "server/dds/domain.hpp"
#include "system/begin.hpp"
#include "system/child_process.hpp"
#include "system/commands.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <string_view>
#include <unistd.h>
#include <variant>
#include <vector>

namespace mirocup::app {

namespace {

// The names of values that the help prints for options which declare no such name.
const system::ValueNames value_names{
    {"--seed", "SEED"},          {"--half", "SECONDS"},      {"--tick", "TICK"},
    {"--match", "ID"},           {"--interface", "NAME"},    {"--join-within", "SECONDS"},
    {"--away-limit", "SECONDS"}, {"--dds-domain", "NUMBER"}, {"--tries", "NUMBER"},
    {"--jobs", "NUMBER"},        {"--at-least", "MARKS"},    {"--name", "NAME"},
    {"--server", "HOST"},        {"--entries", "DIR"},       {"--at", "SECONDS"},
    {"--clip", "FROM:TO"},       {"--noise-mm", "MM"},       {"--noise-deg", "DEGREES"},
    {"--gaps", "SHARE"},         {"--outliers", "SHARE"},    {"--record", "RECORD"},
};

}  // namespace

void add_dds_domain(const system::Command& command, int& domain) {
  command.option("--dds-domain", domain, "DDS domain of the match; each domain has its own ports")
      .between(dds::default_domain, dds::last_domain)
      .shows_default();
}

void add_parameters(const system::Command& command, const char* option,
                    std::vector<std::string>& changes, const std::string& whose) {
  command
      .option(option, changes,
              "Set a parameter of " + whose +
                  ", a number that the strategy asks for by name; may be given several times")
      .named("KEY=VALUE");
}

Result<int> become_sibling_program(const std::string& name, int argc, char** argv, int first) {
  std::vector<std::string> arguments{system::sibling_program(name)};
  if (access(arguments[0].c_str(), F_OK) != 0) {
    return fail(
        Errc::unavailable,
        arguments[0] +
            ": this program is not built; cmake --build --preset release builds everything");
  }
  arguments.insert(arguments.end(), argv + first, argv + argc);
  return tl::unexpected(system::become_program(std::move(arguments)));
}

// Returns the subcommand with its options. If the command line asks for help or is wrong, prints
// the help or the error and returns the exit code instead.
static std::variant<system::Run, int> read_command_line(int argc, char** argv) {
  system::Commands commands("mirocup", "A tournament platform for MiroSot robot soccer.",
                            record::software_version(),
                            "mirocup help COMMAND explains a command, with examples.");
  for (Add* const add :
       {add_match, add_drill, add_check, add_compile, add_hand_in, add_join, add_new, add_export,
        add_verify, add_rerun, add_replay, add_playground, add_stats})
    add(commands);
  commands.add_other(
      {"league",
       for_leagues,
       "Make, play and show leagues: mirocup help league",
       {"mirocup league init spring --team alpha=alpha.so --team house=house:striker",
        "mirocup league start spring"}});
  for (Add* const add : {add_record_as_seen, add_identify, add_validate, add_scene, add_referee})
    add(commands);
  commands.add_other(
      {"tune",
       for_teams,
       "Find better values for a team's parameters: mirocup tune --help",
       {"mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker -o tuned"}});
  commands.add_other({"bench",
                      for_engineers,
                      "Compare speed and error with other engines: mirocup help bench",
                      {"mirocup bench --quick"}});
  add_completion(commands);
  return commands.read(argc, argv, value_names, system::house_teams());
}

}  // namespace mirocup::app

using namespace mirocup;

namespace {

int report(const Result<int>& result) {
  if (result) return *result;
  std::cerr << "mirocup: " << system::printable(result.error().what) << '\n';
  return exit_code(result.error().code);
}

int run(int argc, char** argv) {
  if (const auto begun = system::begin(); !begun) return report(tl::unexpected(begun.error()));
  const std::string_view command = argc > 1 ? argv[1] : "";
  // `complete league WORD…` asks the other program.
  if (command == "complete" && argc > 3 && std::string_view(argv[2]) == "league") {
    std::vector<char*> words{argv[0], argv[2], argv[1]};
    words.insert(words.end(), argv + 3, argv + argc);
    return report(app::become_sibling_program("mirocup-league", static_cast<int>(words.size()),
                                              words.data()));
  }
  if (command == "league") return report(app::become_sibling_program("mirocup-league", argc, argv));
  // The subcommand itself is one of that program.
  if (command == "tune")
    return report(app::become_sibling_program("mirocup-league", argc, argv, 1));
  if (command == "bench") return report(app::become_sibling_program("mirocup-bench", argc, argv));

  const auto chosen = app::read_command_line(argc, argv);
  if (const int* done = std::get_if<int>(&chosen)) return *done;
  return report(std::get<system::Run>(chosen)());
}

}  // namespace

int main(int argc, char** argv) {
  // `mirocup help league start` is `mirocup league start --help`, also for a command of another
  // program.
  if (argc > 2 && std::string_view(argv[1]) == "help") {
    char help[] = "--help";
    std::vector<char*> asked{argv[0]};
    asked.insert(asked.end(), argv + 2, argv + argc);
    asked.insert(asked.end(), {help, nullptr});
    return system::after_standard_output(run(argc, asked.data()));
  }
  return system::after_standard_output(run(argc, argv));
}
