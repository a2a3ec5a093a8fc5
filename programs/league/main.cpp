// SPDX-License-Identifier: MIT
//
// mirocup-league: plays leagues, each in a folder. `mirocup league` starts this program.
#include "programs/league/commands.hpp"
#include "record/match_record.hpp"
#include "system/locations.hpp"
#include "system/run_program.hpp"

namespace mirocup::league {

// An empty name, as of a variable of the shell that is not set, would stand for the folder "/".
std::string problem_with_folder(const std::string& text) {
  return text.empty() ? "\"\" names no folder" : "";
}

static Result<int> run(int argc, char** argv) {
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
  return commands.run(argc, argv, system::house_teams());
}

}  // namespace mirocup::league

int main(int argc, char** argv) {
  return mirocup::system::run_program([&] { return mirocup::league::run(argc, argv); });
}
