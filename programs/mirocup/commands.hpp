// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup`, and what their sources share. Each has one source, which declares
// its options and does its work. A run returns the exit code of an answer, exit_yes or exit_no, or
// an error.
#pragma once

#include "core/replay/verification.hpp"
#include "record/answer.hpp"
#include "record/json_reader.hpp"
#include "system/commands.hpp"
#include "system/files.hpp"
#include "system/printable.hpp"

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::app {

// The headings of the help.
inline constexpr const char* for_teams = "A team";
inline constexpr const char* after_a_leg = "After a leg";
inline constexpr const char* for_leagues = "Leagues";
inline constexpr const char* for_engineers = "Referee, pitches and physics";
inline constexpr const char* for_shells = "Shells";

// Each declares its subcommand.
using Add = void(system::Commands& commands);
Add add_match, add_drill, add_grade, add_check, add_compile, add_hand_in, add_join, add_new,
    add_verify, add_rerun, add_replay, add_stats, add_coach, add_playground, add_workbench,
    add_scene, add_referee, add_completion;

// Returns the script that a shell reads to complete the words after `mirocup`: "bash", "zsh" or
// "fish"; it is the file of that name in completion/. The script runs `mirocup complete WORD…`, so
// it is never out of date.
std::string_view completion_script(std::string_view shell);

// Options of several subcommands.
inline constexpr double longest_wait_s = 1e6;  // for a team or a match
void add_dds_domain(const system::Command& command, int& domain);
// Adds an option KEY=VALUE for the parameters of a team, which the help calls `whose`: "the team".
void add_parameters(const system::Command& command, const char* option,
                    std::vector<std::string>& changes, const std::string& whose);
// A command that mirocup-league runs: `run` gets the options, which have a member `answer`, the
// path of the option --answer, and what writes there (record/answer.hpp).
template <auto run, class Options>
Result<int> answering(const Options& options) {
  return record::answering(options.answer,
                           [&](const record::WriteAnswer& write) { return run(options, write); });
}
void add_answer(const system::Command& command, std::string& path);

// Prints a value in one line.
inline void print_json(const record::Json& json) {
  std::cout << record::json_text(json) << '\n';
}

// Returns the answer of a command that cannot do what `undone` says ("shown") with a record, since
// the leg differs from the record: prints so, or returns the error of a record of another version.
Result<int> not_reproduced(const std::string& path, const record::MatchRecord& record,
                           const replay::Divergence& found, const char* undone);

// Runs mirocup-labs in the place of this process. Returns only if it cannot be run.
Error become_labs(std::vector<std::string> arguments);

}  // namespace mirocup::app
