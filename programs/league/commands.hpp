// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup league`, and what their sources share. A source declares the options
// of its commands and does their work. A run returns the exit code of an answer, exit_yes or
// exit_no, or an error.
#pragma once

#include "record/json_reader.hpp"
#include "system/commands.hpp"
#include "system/printable.hpp"
#include "tournaments/league/league_store.hpp"

#include <iostream>
#include <string>
#include <string_view>

namespace mirocup::league {

// The headings of the help.
inline constexpr const char* to_make = "Make";
inline constexpr const char* to_take = "Entries";
inline constexpr const char* to_play = "Play";
inline constexpr const char* to_show = "Show";
inline constexpr const char* to_rule = "Decide";
inline constexpr const char* on_clusters = "Many computers";

// Each function declares its subcommand; add_acts() declares the subcommands of all acts.
using Add = void(system::Commands& commands);
Add add_init, add_submit, add_nightly, add_start, add_stop, add_status, add_health, add_stats,
    add_publish, add_prune, add_serve, add_show, add_export, add_token, add_check_hand_in,
    add_play_friendly, add_acts, add_decisions, add_verify, add_backup, add_grades, add_team,
    add_compare, add_plan, add_run_shard, add_credentials, add_index, add_take;

// Return the text of a file that the build compiles into the program: README.md, or the file
// show/NAME; empty if the program lacks the file.
std::string_view given_file(std::string_view name);
std::string_view show_file(std::string_view name);

// Prints a value in one line.
inline void print_json(const Json& json) {
  std::cout << record::json_text(json) << '\n';
}

// The options of a command about a league; those of a command with more options derive from these.
struct LeagueOptions {
  std::string folder;  // the argument DIR
};

// The run of a command that needs the league open: `run` gets the disk, the league and the options.
template <auto run, class Options = LeagueOptions>
Result<int> on_league(const Options& options) {
  system::Disk disk;
  MIROCUP_TRY(auto store, LeagueStore::open(disk, Folder{options.folder}));
  return run(disk, store, options);
}

// The same for a command that only the owner of the folder may give: expect_owner().
template <auto run, class Options = LeagueOptions>
Result<int> on_own_league(const Options& options) {
  MIROCUP_TRY_VOID(expect_owner(Folder{options.folder}));
  return on_league<run>(options);
}

// Returns why a text cannot be the name of a folder; "" if it can.
std::string problem_with_folder(const std::string& text);

// Adds a command with the argument DIR, as Commands::add() does.
template <class Options>
system::Commands::Added<Options> add_command(system::Commands& commands,
                                             Result<int> (*run)(const Options&), const char* name,
                                             const char* group, const char* description,
                                             std::vector<const char*> examples) {
  const auto added = commands.add(run, name, group, description, std::move(examples));
  added.command.option("DIR", added.options.folder, "Folder of the league")
      .required()
      .checked("DIR", problem_with_folder);
  return added;
}

}  // namespace mirocup::league
