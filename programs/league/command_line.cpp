// SPDX-License-Identifier: MIT
#include "programs/league/command_line.hpp"

#include "programs/league/commands.hpp"
#include "record/match_record.hpp"
#include "system/locations.hpp"

namespace mirocup::league {

namespace {

// What the values of options are called, for options that do not say it themselves.
const system::ValueNames value_names{
    {"--config", "FILE"},       {"--team", "NAME"},
    {"--half", "SECONDS"},      {"--seed", "SEED"},
    {"--inbox", "DIR"},         {"--jobs", "NUMBER"},
    {"--dds-domain", "NUMBER"}, {"--output", "DIR"},
    {"--through", "ROUND"},     {"--round", "ROUND"},
    {"--at", "[HOST:]PORT"},    {"--leg", "NUMBER"},
    {"--reason", "TEXT"},       {"--by", "NAME"},
    {"--score", "HOME:AWAY"},   {"--expires", "TIME"},
    {"--most", "NUMBER"},       {"--equal", "ELO"},
    {"--keep", "DIR"},          {"--revoke", "TEAM"},
    {"--days", "DAYS"},         {"--display", "NAME"},
    {"--member", "NAME"},       {"--param", "KEY=LOW:HIGH"},
    {"--against", "TEAM,TEAM"}, {"--generations", "NUMBER"},
    {"--fixtures", "NUMBER"},   {"--test", "NUMBER"},
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

std::variant<system::Run, int> read_command_line(int argc, char** argv) {
  system::Commands commands(
      "mirocup league", "Leagues of MiroSot robot soccer: a league is a folder.",
      record::software_version(), "mirocup league help COMMAND explains a command, with examples.");
  add_init(commands);
  add_submit(commands);
  add_owner(commands);
  add_nightly(commands);
  add_start(commands);
  add_stop(commands);
  add_status(commands);
  add_health(commands);
  add_stats(commands);
  add_publish(commands);
  add_prune(commands);
  add_serve(commands);
  add_show(commands);
  add_export(commands);
  add_token(commands);
  add_check_hand_in(commands);
  add_play_friendly(commands);
  add_award(commands);
  add_rule(commands);
  add_void(commands);
  add_withdraw(commands);
  add_pause(commands);
  add_resume(commands);
  add_freeze(commands);
  add_release(commands);
  add_close(commands);
  add_undo(commands);
  add_decisions(commands);
  add_verify(commands);
  add_backup(commands);
  add_grades(commands);
  add_team(commands);
  add_compare(commands);
  add_tune(commands);
  add_plan(commands);
  add_run_shard(commands);
  add_credentials(commands);
  return commands.read(argc, argv, value_names, system::house_teams());
}

}  // namespace mirocup::league
