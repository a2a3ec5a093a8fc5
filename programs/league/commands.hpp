// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup league`. Each has one source, which declares its options and does its
// work; acts.cpp has all acts of the staff. A run returns the exit code of an answer, exit_yes or
// exit_no, or an error.
#pragma once

#include "system/commands.hpp"

#include <string>
#include <string_view>

namespace mirocup::league {

struct ComparisonRun;

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

// The argument DIR, the league's folder.
void add_folder(const system::Command& command, std::string& folder);

// The options --league, --half and --conditions of a comparison.
void add_terms(const system::Command& command, std::string& league, ComparisonRun& run);

// Returns why a text cannot be the name of a folder; "" if it can.
std::string problem_with_folder(const std::string& text);

}  // namespace mirocup::league
