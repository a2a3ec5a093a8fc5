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

#include <algorithm>
#include <iostream>
#include <string_view>
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
    {"--clip", "FROM:TO"},       {"--record", "RECORD"},
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

void add_answer(const system::Command& command, std::string& path) {
  command.option("--answer", path).hidden();
}

Error become_labs(std::vector<std::string> arguments) {
  Error error =
      system::become_sibling_program("mirocup-labs", std::move(arguments), "-D MIROCUP_LABS=ON");
  error.what += "; an installation has it in the package mirocup-labs";
  return error;
}

// The commands that mirocup-labs runs.
static const std::vector<system::CommandHelp>& commands_of_labs() {
  static const std::vector<system::CommandHelp> commands{
      {"export",
       for_teams,
       "Write a learned network as the source of a team",
       {"mirocup export policy.npz -o learned.cpp"}},
      {"tune",
       for_teams,
       "Find better values for a team's parameters",
       {"mirocup tune mine.so --param wait=0.3:0.6 --against chaser,striker -o tuned"}},
      {"record-as-seen",
       for_engineers,
       "Write what a camera would have seen of a played match, as a recording",
       {"mirocup record-as-seen leg.json -o seen.jsonl"}},
      {"identify",
       for_engineers,
       "Find the numbers of a pitch from recordings: floor, walls, motors, camera",
       {"mirocup identify seen.jsonl -o ours.json --page ours.html"}},
      {"validate",
       for_engineers,
       "Print how well the simulator predicts recordings",
       {"mirocup validate seen.jsonl --pitch ours.json -o validation.html"}},
      {"bench",
       for_engineers,
       "Compare speed and error with other engines",
       {"mirocup bench --quick"}}};
  return commands;
}

static bool is_of_labs(const std::string& name) {
  const auto& commands = commands_of_labs();
  return std::any_of(commands.begin(), commands.end(),
                     [&](const system::CommandHelp& help) { return help.name == name; });
}

// Returns the subcommand with its options. If the command line asks for help or is wrong, prints
// the help or the error and returns the exit code instead.
static std::variant<system::Run, int> read_command_line(int argc, char** argv) {
  system::Commands commands("mirocup", "A tournament platform for MiroSot robot soccer.",
                            record::software_version(),
                            "mirocup help COMMAND explains a command, with examples.");
  for (Add* const add : {add_match, add_drill, add_check, add_compile, add_hand_in, add_join,
                         add_new, add_verify, add_rerun, add_replay, add_playground, add_stats})
    add(commands);
  commands.add_other(
      {"league",
       for_leagues,
       "Make, play and show leagues: mirocup help league",
       {"mirocup league init spring --team alpha=alpha.so --team house=house:striker",
        "mirocup league start spring"}});
  for (const system::CommandHelp& help : commands_of_labs()) commands.add_other(help);
  for (Add* const add : {add_scene, add_referee}) add(commands);
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
  // `complete COMMAND WORD…` asks the program that runs the command.
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const bool completes = words.size() > 2 && words[0] == "complete";
  const auto command = words.begin() + (completes ? 1 : 0);
  const bool is_tune_of_league = words.size() > 1 && words[0] == "league" && words[1] == "tune";
  if (is_tune_of_league || (command != words.end() && *command == "league")) {
    words.erase(command);
    return report(tl::unexpected(is_tune_of_league
                                     ? app::become_labs(words)
                                     : system::become_sibling_program("mirocup-league", words)));
  }
  if (command != words.end() && app::is_of_labs(*command))
    return report(tl::unexpected(app::become_labs(words)));

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
