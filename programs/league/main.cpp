// SPDX-License-Identifier: MIT
//
// mirocup-league: plays leagues, each in a folder. `mirocup league` starts this program.
#include "programs/league/commands.hpp"
#include "record/match_record.hpp"
#include "system/begin.hpp"
#include "system/commands.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <variant>

namespace mirocup::league {

namespace {

// The names of values that the help prints for options which declare no such name.
const system::ValueNames value_names{
    {"--config", "FILE"},       {"--team", "NAME"},      {"--half", "SECONDS"},
    {"--seed", "SEED"},         {"--run", "COMMAND"},    {"--jobs", "NUMBER"},
    {"--dds-domain", "NUMBER"}, {"--output", "DIR"},     {"--through", "ROUND"},
    {"--round", "ROUND"},       {"--at", "[HOST:]PORT"}, {"--leg", "NUMBER"},
    {"--reason", "TEXT"},       {"--by", "NAME"},        {"--score", "HOME:AWAY"},
    {"--expires", "TIME"},      {"--most", "NUMBER"},    {"--equal", "ELO"},
    {"--keep", "DIR"},          {"--revoke", "TEAM"},    {"--days", "DAYS"},
    {"--display", "NAME"},      {"--member", "NAME"},
};

}  // namespace

void add_folder(const system::Command& command, std::string& folder) {
  command.option("DIR", folder, "Folder of the league")
      .required()
      .checked("DIR", problem_with_folder);
}

// An empty name, as of a variable of the shell that is not set, would stand for the folder "/".
std::string problem_with_folder(const std::string& text) {
  return text.empty() ? "\"\" names no folder" : "";
}

// Returns the subcommand with its options. If the command line asks for help or is wrong, prints
// the help or the error and returns the exit code instead.
static std::variant<system::Run, int> read_command_line(int argc, char** argv) {
  system::Commands commands(
      "mirocup league", "Leagues of MiroSot robot soccer: a league is a folder.",
      record::software_version(), "mirocup league help COMMAND explains a command, with examples.");
  for (Add* const add :
       {add_init,          add_submit, add_nightly,   add_start,   add_stop,
        add_status,        add_health, add_stats,     add_publish, add_prune,
        add_serve,         add_show,   add_export,    add_token,   add_check_hand_in,
        add_play_friendly, add_acts,   add_decisions, add_verify,  add_backup,
        add_grades,        add_team,   add_compare,   add_plan,    add_run_shard,
        add_credentials,   add_index,  add_take})
    add(commands);
  return commands.read(argc, argv, value_names, system::house_teams());
}

}  // namespace mirocup::league

using namespace mirocup;

namespace {

Result<int> run(int argc, char** argv) {
  MIROCUP_TRY_VOID(system::begin());
  const auto chosen = league::read_command_line(argc, argv);
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
