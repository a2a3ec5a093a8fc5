// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup league`. Each has one source, which declares its options and does its
// work; acts.cpp has all acts of the staff. A run returns the exit code of an answer, exit_yes or
// exit_no, or an error.
#pragma once

#include "system/commands.hpp"

#include <string>

namespace mirocup::league {

// The headings of the help.
inline constexpr const char* to_make = "Make";
inline constexpr const char* to_take = "Entries";
inline constexpr const char* to_play = "Play";
inline constexpr const char* to_show = "Show";
inline constexpr const char* to_rule = "Decide";
inline constexpr const char* on_clusters = "Many computers";

void add_init(system::Commands& commands);
void add_submit(system::Commands& commands);
void add_owner(system::Commands& commands);
void add_nightly(system::Commands& commands);
void add_start(system::Commands& commands);
void add_stop(system::Commands& commands);
void add_status(system::Commands& commands);
void add_health(system::Commands& commands);
void add_stats(system::Commands& commands);
void add_publish(system::Commands& commands);
void add_prune(system::Commands& commands);
void add_serve(system::Commands& commands);
void add_show(system::Commands& commands);
void add_export(system::Commands& commands);
void add_token(system::Commands& commands);
void add_check_hand_in(system::Commands& commands);
void add_play_friendly(system::Commands& commands);
void add_award(system::Commands& commands);
void add_rule(system::Commands& commands);
void add_void(system::Commands& commands);
void add_withdraw(system::Commands& commands);
void add_pause(system::Commands& commands);
void add_resume(system::Commands& commands);
void add_freeze(system::Commands& commands);
void add_release(system::Commands& commands);
void add_close(system::Commands& commands);
void add_undo(system::Commands& commands);
void add_decisions(system::Commands& commands);
void add_verify(system::Commands& commands);
void add_backup(system::Commands& commands);
void add_grades(system::Commands& commands);
void add_team(system::Commands& commands);
void add_compare(system::Commands& commands);
void add_tune(system::Commands& commands);
void add_plan(system::Commands& commands);
void add_run_shard(system::Commands& commands);
void add_credentials(system::Commands& commands);

// The argument DIR, the league's folder.
void add_folder(const system::Command& command, std::string& folder);

// Returns why a text cannot be the name of a folder; "" if it can.
std::string problem_with_folder(const std::string& text);

}  // namespace mirocup::league
